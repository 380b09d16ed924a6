#include "mpi/worker.hpp"

#include <chrono>
#include <utility>

namespace graze::mpi {

namespace {

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos; }

}  // namespace

Answered Worker::work(const Chunk& chunk) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string questions = questions_.read(chunk.offset, chunk.length);
  Answered answered;
  answered.record.chunk = chunk.number;
  answered.record.questions = checksum(questions);
  std::string_view rest = questions;
  for (std::uint64_t number = chunk.first_line; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (!blank(line)) answered.record.errors += answer_(line, number, answered.text) ? 1 : 0;
  }
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
