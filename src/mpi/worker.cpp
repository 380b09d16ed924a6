#include "mpi/worker.hpp"

#include <chrono>
#include <utility>

namespace graze::mpi {

namespace {

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos; }

}  // namespace

void Worker::answer_lines(std::string_view lines, std::uint64_t first, Answered& answered) const {
  for (std::uint64_t number = first; !lines.empty(); ++number) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    if (!blank(line)) answered.record.errors += answer_(line, number, answered.text) ? 1 : 0;
  }
}

void Worker::answer_records(std::string_view records, std::uint64_t first, Answered& answered) const {
  for (std::uint64_t number = first; !records.empty(); ++number) {
    answered.record.errors += answer_(records.substr(0, record_bytes_), number, answered.text) ? 1 : 0;
    records.remove_prefix(record_bytes_);
  }
}

Answered Worker::work(const Chunk& chunk) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string questions = questions_.read(chunk.offset, chunk.length);
  Answered answered;
  answered.record.chunk = chunk.number;
  answered.record.questions = checksum(questions);
  if (record_bytes_ > 0)
    answer_records(questions, chunk.first_line, answered);
  else
    answer_lines(questions, chunk.first_line, answered);
  if (journal_) {
    journal_->append(answered.record, answered.text);
    answered.text = {};
  }
  answered.record.length = journal_ ? answered.record.length : answered.text.size();
  answered.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return answered;
}

LocalWorker::LocalWorker(Worker worker) : worker_(worker), thread_([this] { run(); }) {}

LocalWorker::~LocalWorker() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void LocalWorker::give(const Chunk& chunk) {
  {
    const std::lock_guard lock(mutex_);
    given_.push_back(chunk);
  }
  changed_.notify_one();
}

std::optional<Answered> LocalWorker::take() {
  const std::lock_guard lock(mutex_);
  if (failed_) std::rethrow_exception(failed_);
  if (done_.empty()) return std::nullopt;
  std::optional<Answered> first = std::move(done_.front());
  done_.pop_front();
  return first;
}

void LocalWorker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return stopped_ || !given_.empty(); });
    if (stopped_) return;
    const Chunk chunk = given_.front();
    given_.pop_front();
    lock.unlock();
    Answered answered;
    std::exception_ptr failed;
    try {
      answered = worker_.work(chunk);
    } catch (...) {
      failed = std::current_exception();
    }
    lock.lock();
    failed_ = failed;
    if (failed) return;
    done_.push_back(std::move(answered));
  }
}

}  // namespace graze::mpi
