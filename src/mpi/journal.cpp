#include "mpi/journal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include "graze/error.hpp"

namespace graze::mpi {

namespace {

namespace fs = std::filesystem;

/// Words before each text: five numbers and the checksum of these.
struct RecordHead {
  std::uint64_t chunk, questions, errors, length, text;
  std::uint64_t check;
};
static_assert(sizeof(RecordHead) == 6 * sizeof(std::uint64_t));

std::uint64_t check_of(const RecordHead& head) {
  std::array<char, sizeof(RecordHead) - sizeof(std::uint64_t)> bytes{};
  std::memcpy(bytes.data(), &head, bytes.size());
  return checksum({bytes.data(), bytes.size()});
}

/// The records of a part up to the first that is not whole.
void read_part(const std::string& name, std::uint64_t part, std::vector<Record>& out) {
  const File file = File::reading(name);
  const std::uint64_t size = file.size();
  std::uint64_t at = 0;
  while (size - at >= sizeof(RecordHead)) {
    RecordHead head{};
    std::array<char, sizeof head> bytes{};
    file.read(at, bytes.data(), bytes.size());
    std::memcpy(&head, bytes.data(), bytes.size());
    at += sizeof head;
    if (head.check != check_of(head) || head.length > size - at) return;
    if (checksum(file.read(at, head.length)) != head.text) return;
    out.push_back({head.chunk, head.questions, head.errors, part, at, head.length});
    at += head.length;
  }
}

/// The number in the name of a part, if it is one.
std::optional<std::uint64_t> part_in(const std::string& name) {
  constexpr std::string_view prefix = "part-";
  if (!name.starts_with(prefix)) return std::nullopt;
  const char *const begin = name.data() + prefix.size(), *const end = name.data() + name.size();
  std::uint64_t run = 0, rank = 0;
  const auto first = std::from_chars(begin, end, run);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '-') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, rank);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return run << 32 | rank;
}

std::vector<std::uint64_t> parts_in(const std::string& directory) {
  std::vector<std::uint64_t> parts;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory))
    if (const auto part = part_in(entry.path().filename().string())) parts.push_back(*part);
  std::sort(parts.begin(), parts.end());
  return parts;
}

void remove_parts(const std::string& directory) {
  for (const std::uint64_t part : parts_in(directory)) fs::remove(Journal::part_name(directory, part));
}

/// Locks the file, with some patience: processes of a run that was ended a moment ago may still hold the journal.
bool locked_soon(const File& file) {
  constexpr int tries = 50;
  for (int i = 0; i < tries; ++i) {
    if (file.lock()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return sum;
}

std::string Journal::part_name(const std::string& directory, std::uint64_t part) {
  return directory + "/part-" + std::to_string(part >> 32) + "-" + std::to_string(part & 0xffffffff);
}

/// Opens a journal. A head that is not whole is that of a run which was killed before anything was answered: it is
/// written anew.
Journal Journal::open(const std::string& directory, const std::string& head) {
  Journal journal;
  journal.directory_ = directory;
  const bool there = fs::exists(directory);
  fs::create_directories(directory);
  const std::string name = directory + "/head";
  if (there && !fs::exists(name) && parts_in(directory).empty() && !fs::is_empty(directory))
    throw InvalidValue(directory, "the journal of a sweep, or nothing", "a directory of something else");
  journal.head_ = File::writing(name);
  if (!locked_soon(journal.head_)) throw InvalidValue(directory, "a journal that no other run uses", "one in use");
  // Another run may have come to its end while this one waited, and its journal is gone.
  if (!fs::exists(name)) return open(directory, head);
  const std::string had = journal.head_.read(0, journal.head_.size());
  if (had != head) {
    if (had.ends_with('\n'))
      throw InvalidValue(directory, "the journal of this sweep (" + head.substr(0, head.size() - 1) + ")",
                         "that of another (" + had.substr(0, had.size() - 1) + "); remove it to begin anew");
    remove_parts(directory);
    fs::resize_file(name, 0);
    journal.head_.append(head);
  }
  for (const std::uint64_t part : parts_in(directory)) {
    journal.run_ = std::max(journal.run_, (part >> 32) + 1);
    read_part(part_name(directory, part), part, journal.known_);
  }
  return journal;
}

void Journal::remove() {
  fs::remove(head_.name());
  remove_parts(directory_);
  head_ = {};
  std::error_code ignored;  // what somebody else put there stays
  fs::remove(directory_, ignored);
}

JournalPart::JournalPart(const std::string& directory, std::uint64_t part)
    : file_(File::writing(Journal::part_name(directory, part))), part_(part), end_(file_.size()) {}

void JournalPart::append(Record& record, std::string_view text) {
  RecordHead head{record.chunk, record.questions, record.errors, text.size(), checksum(text), 0};
  head.check = check_of(head);
  std::string bytes(sizeof head, '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  bytes += text;
  file_.append(bytes);
  record.part = part_;
  record.offset = end_ + sizeof head;
  record.length = text.size();
  end_ += bytes.size();
}

}  // namespace graze::mpi
