#include "graze/mpi/sweep.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <system_error>
#include <unordered_map>

#include "graze/error.hpp"
#include "io/link_target.hpp"
#include "mpi/messages.hpp"
#include "mpi/sweep_output.hpp"
#include "mpi/worker.hpp"

namespace graze::mpi {

namespace {

constexpr int tag_chunk = 1, tag_answered = 2, tag_text = 3;

/// Chunks that a rank has at a time: the next is there when one is done.
constexpr std::size_t in_flight = 2;

// Sizes of messages, in words.
constexpr int chunk_words = 4, answered_words = 7;
constexpr std::uint64_t no_chunk = ~std::uint64_t{0};

std::array<std::uint64_t, chunk_words> words_of(const Chunk& c) { return {c.number, c.offset, c.length, c.first_line}; }

void send_answered(MPI_Comm comm, const Answered& answered) {
  const Record& r = answered.record;
  std::array<std::uint64_t, answered_words> words{r.chunk, r.errors, r.part, r.offset, r.length, answered.text.size()};
  std::memcpy(&words.back(), &answered.seconds, sizeof answered.seconds);
  MPI_Send(words.data(), answered_words, MPI_UINT64_T, 0, tag_answered, comm);
  send(comm, answered.text, 0, tag_text);
}

/// The answers that a rank has sent, if anything.
std::optional<std::pair<int, Answered>> receive_answered(MPI_Comm comm) {
  int there = 0;
  MPI_Status status{};
  MPI_Iprobe(MPI_ANY_SOURCE, tag_answered, comm, &there, &status);
  if (there == 0) return std::nullopt;
  std::array<std::uint64_t, answered_words> words{};
  MPI_Recv(words.data(), answered_words, MPI_UINT64_T, status.MPI_SOURCE, tag_answered, comm, MPI_STATUS_IGNORE);
  Answered answered;
  answered.record = {words[0], 0, words[1], words[2], words[3], words[4]};
  answered.text.resize(words[5]);
  std::memcpy(&answered.seconds, &words.back(), sizeof answered.seconds);
  receive(comm, answered.text, status.MPI_SOURCE, tag_text);
  return std::pair(status.MPI_SOURCE, std::move(answered));
}

/// Works for the first rank: the part of all others.
void work_for_first(MPI_Comm comm, Worker worker) {
  while (true) {
    Patience patience;
    for (int there = 0; there == 0;) {
      MPI_Iprobe(0, tag_chunk, comm, &there, MPI_STATUS_IGNORE);
      if (there == 0) patience.wait();
    }
    std::array<std::uint64_t, chunk_words> words{};
    MPI_Recv(words.data(), chunk_words, MPI_UINT64_T, 0, tag_chunk, comm, MPI_STATUS_IGNORE);
    if (words[0] == no_chunk) return;
    send_answered(comm, worker.work({words[0], words[1], words[2], words[3]}));
  }
}

/// The part of rank 0: hands out chunks and gathers what is answered.
class Coordinator {
 public:
  Coordinator(MPI_Comm comm, const File& questions, std::uint64_t record_bytes, const std::vector<Record>& known,
              std::ostream* stream)
      : comm_(comm), questions_(questions), chunks_(questions, record_bytes), stream_(stream), open_(size_of(comm), 0) {
    for (const Record& record : known) known_.emplace(record.chunk, record);
    report_.by_rank.assign(open_.size(), 0);
    report_.busy.assign(open_.size(), 0);
  }

  void run(Worker own) {
    LocalWorker local(own);
    for (std::size_t i = 0; i < in_flight; ++i)
      for (std::size_t rank = 0; rank < open_.size(); ++rank) give(rank, local);
    Patience patience;
    while (left_ > 0) {
      bool any = false;
      if (auto done = local.take()) any = true, took(0, std::move(*done), local);
      if (auto done = receive_answered(comm_))
        any = true, took(static_cast<std::size_t>(done->first), std::move(done->second), local);
      any ? patience.reset() : patience.wait();
    }
    std::array<std::uint64_t, chunk_words> end{no_chunk};
    for (int rank = 1; rank < size_of(comm_); ++rank)
      MPI_Send(end.data(), chunk_words, MPI_UINT64_T, rank, tag_chunk, comm_);
    report_.lines = chunks_.lines();
  }

  const std::vector<Record>& records() const { return records_; }
  SweepReport take_report() { return std::move(report_); }

 private:
  void give(std::size_t rank, LocalWorker& local) {
    Chunk chunk;
    if (!next(chunk)) return;
    ++left_;
    if (rank == 0) return local.give(chunk);
    const auto words = words_of(chunk);
    MPI_Send(words.data(), chunk_words, MPI_UINT64_T, static_cast<int>(rank), tag_chunk, comm_);
  }

  /// The next chunk that the journal does not have.
  bool next(Chunk& chunk) {
    while (chunks_.next(chunk)) {
      ++report_.chunks;
      const auto known = known_.find(chunk.number);
      if (known == known_.end()) return true;
      if (checksum(questions_.read(chunk.offset, chunk.length)) != known->second.questions)
        throw InvalidValue(questions_.name(), "the questions that the journal has answers to",
                           "others from line " + std::to_string(chunk.first_line) +
                               " on; remove the journal to begin anew");
      ++report_.remembered;
      keep({known->second, {}, 0});
    }
    return false;
  }

  void took(std::size_t rank, Answered&& answered, LocalWorker& local) {
    --left_;
    ++report_.by_rank[rank];
    report_.busy[rank] += answered.seconds;
    keep(std::move(answered));
    give(rank, local);
  }

  void keep(Answered&& answered) {
    report_.errors += answered.record.errors;
    if (!stream_) {
      const std::size_t at = answered.record.chunk;
      if (records_.size() <= at) records_.resize(at + 1);
      records_[at] = answered.record;
      return;
    }
    waiting_.emplace(answered.record.chunk, std::move(answered.text));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == written_; ++written_) {
      *stream_ << first->second;
      first = waiting_.erase(first);
    }
    if (waiting_.empty()) stream_->flush();
    if (!*stream_)
      throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), "answers cannot be written");
  }

  MPI_Comm comm_;
  const File& questions_;
  LineChunks chunks_;
  std::unordered_map<std::uint64_t, Record> known_;
  std::ostream* stream_;  ///< for the answers, or null where they are in the journal
  std::vector<std::size_t> open_;
  std::size_t left_ = 0;
  std::vector<Record> records_;                   ///< by chunk
  std::map<std::uint64_t, std::string> waiting_;  ///< answers behind one that is not there yet
  std::uint64_t written_ = 0;
  SweepReport report_;
};

/// One line that identifies the sweep of a journal.
std::string head_of(const SweepSettings& settings, const File& questions) {
  return "graze sweep 1; " + settings.kind + "; " + std::to_string(LineChunks::most_lines) + " lines or " +
         std::to_string(LineChunks::most_bytes) + " bytes; of " + std::to_string(questions.size()) + " bytes" +
         (settings.record_bytes > 0 ? " in records of " + std::to_string(settings.record_bytes) : "") + "\n";
}

/// Calls `f` on one rank's behalf and throws its errors on all ranks.
template <class F>
void begin(MPI_Comm comm, F&& f) {
  std::string fault;
  try {
    f();
  } catch (const std::exception& e) {
    fault = e.what();
  }
  agree(comm, fault);
}

}  // namespace

SweepReport sweep_lines(MPI_Comm comm, const SweepSettings& settings, const LineAnswer& answer, std::ostream& stream) {
  const int rank = rank_of(comm);
  const std::string directory = !settings.journal.empty() ? settings.journal
                                : settings.out.empty()    ? ""
                                                          : settings.out + ".journal";
  const std::string out = settings.out.empty() ? "" : io::link_target(settings.out).string();
  agree_on(comm, "the program", settings.kind);
  File questions;
  begin(comm, [&] {
    questions = File::reading(settings.questions);
    if (!questions.regular()) throw InvalidValue(settings.questions, "a regular file", "something else");
    if (settings.record_bytes > 0 && questions.size() % settings.record_bytes != 0)
      throw InvalidValue(settings.questions, "records of " + std::to_string(settings.record_bytes) + " bytes each",
                         std::to_string(questions.size()) + " bytes");
  });
  agree_on(comm, "the questions", settings.questions + " of " + std::to_string(questions.size()) + " bytes");
  agree_on(comm, "the output and the journal", "'" + settings.out + "' and '" + directory + "'");
  const bool kept = !directory.empty();
  Journal journal;
  std::uint64_t run = 0;
  begin(comm, [&] {
    if (rank != 0 || !kept) return;
    if (!out.empty()) {
      const auto there = std::filesystem::status(out);
      if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        throw InvalidValue(settings.out, "a regular file, or nothing", "something else");
      // The answers are first written to the second of these.
      for (const std::string& file : {out, partial_name(out)})
        if (std::filesystem::exists(file) && std::filesystem::equivalent(file, settings.questions))
          throw InvalidValue(file == out ? settings.out : file, "another file than the questions", "the questions");
      // A link of that name would take the place of the output, and its target be written over.
      if (std::filesystem::is_symlink(partial_name(out))) std::filesystem::remove(partial_name(out));
      File::writing(partial_name(out));
    }
    journal = Journal::open(directory, head_of(settings, questions));
    run = journal.run();
  });
  MPI_Bcast(&run, 1, MPI_UINT64_T, 0, comm);
  JournalPart part;
  begin(comm, [&] {
    if (kept) part = JournalPart(directory, Journal::part_of(run, rank));
  });

  const Worker worker(questions, settings.record_bytes, kept ? &part : nullptr, answer);
  SweepReport report;
  std::vector<Record> records;
  if (rank == 0) {
    Coordinator coordinator(comm, questions, settings.record_bytes, journal.known(), kept ? nullptr : &stream);
    coordinator.run(worker);
    report = coordinator.take_report();
    records = coordinator.records();
  } else {
    work_for_first(comm, worker);
  }
  if (kept && settings.out.empty() && rank == 0) write_to_stream(directory, records, stream);
  if (kept && !settings.out.empty()) write_together(comm, directory, std::move(records), out);
  MPI_Barrier(comm);
  if (rank == 0 && kept) journal.remove();
  std::array<std::uint64_t, 2> told{report.errors, report.lines};
  MPI_Bcast(told.data(), 2, MPI_UINT64_T, 0, comm);
  report.errors = told[0];
  report.lines = told[1];
  return report;
}

}  // namespace graze::mpi
