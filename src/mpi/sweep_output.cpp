#include "mpi/sweep_output.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <map>
#include <ostream>
#include <system_error>

#include "mpi/messages.hpp"

namespace graze::mpi {

namespace {

/// Bytes that are read and written at a time.
constexpr std::uint64_t bytes_at_once = 1 << 23;

/// The files of a journal, each opened once.
class Parts {
 public:
  explicit Parts(const std::string& directory) : directory_(directory) {}
  const File& operator[](std::uint64_t part) {
    File& file = files_[part];
    if (!file.open()) file = File::reading(Journal::part_name(directory_, part));
    return file;
  }

 private:
  const std::string& directory_;
  std::map<std::uint64_t, File> files_;
};

void check(int error, const std::string& name) {
  if (error == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0, kind = MPI_SUCCESS;
  MPI_Error_string(error, text.data(), &length);
  MPI_Error_class(error, &kind);
  const int reason = kind == MPI_ERR_NO_SPACE || kind == MPI_ERR_QUOTA ? ENOSPC : EIO;
  throw std::system_error(reason, std::generic_category(), name + ": cannot be written: " + text.data());
}

/// A file that all ranks write, each at places of its own.
class SharedFile {
 public:
  SharedFile(MPI_Comm comm, const std::string& name) : name_(name) {
    check(MPI_File_open(comm, name.c_str(), MPI_MODE_WRONLY | MPI_MODE_CREATE, MPI_INFO_NULL, &file_), name);
  }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  ~SharedFile() { MPI_File_close(&file_); }

  void resize(std::uint64_t size) { check(MPI_File_set_size(file_, static_cast<MPI_Offset>(size)), name_); }
  void write(std::uint64_t offset, const std::string& bytes) {
    MPI_Status status{};
    check(MPI_File_write_at(file_, static_cast<MPI_Offset>(offset), bytes.data(), static_cast<int>(bytes.size()),
                            MPI_BYTE, &status),
          name_);
    int count = 0;
    MPI_Get_count(&status, MPI_BYTE, &count);
    if (count == static_cast<int>(bytes.size())) return;
    throw std::system_error(ENOSPC, std::generic_category(), name_ + ": cannot be written");
  }
  void flush() { check(MPI_File_sync(file_), name_); }

 private:
  MPI_File file_ = MPI_FILE_NULL;
  std::string name_;
};

/// Sends all records to all ranks.
void share(MPI_Comm comm, std::vector<Record>& records) {
  static_assert(std::is_trivially_copyable_v<Record>);
  std::uint64_t count = records.size();
  MPI_Bcast(&count, 1, MPI_UINT64_T, 0, comm);
  records.resize(count);
  char* const bytes = reinterpret_cast<char*>(records.data());
  each_piece(records.size() * sizeof(Record),
             [&](std::size_t begin, int size) { MPI_Bcast(bytes + begin, size, MPI_BYTE, 0, comm); });
}

}  // namespace

std::string partial_name(const std::string& out) { return out + ".partial"; }

void write_to_stream(const std::string& directory, const std::vector<Record>& records, std::ostream& stream) {
  Parts parts(directory);
  for (const Record& record : records)
    for (std::uint64_t at = 0; at < record.length; at += bytes_at_once)
      stream << parts[record.part].read(record.offset + at, std::min(bytes_at_once, record.length - at));
  stream.flush();
  if (!stream) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), "answers cannot be written");
}

/// Writes the output. The ranks take its bytes in equal parts, rounded to records.
void write_together(MPI_Comm comm, const std::string& directory, std::vector<Record> records, const std::string& out) {
  share(comm, records);
  std::uint64_t size = 0;
  for (const Record& record : records) size += record.length;
  const auto rank = static_cast<std::uint64_t>(rank_of(comm)), ranks = static_cast<std::uint64_t>(size_of(comm));
  const std::string partial = partial_name(out);
  {
    SharedFile file(comm, partial);
    file.resize(size);
    Parts parts(directory);
    std::string waiting;
    std::uint64_t at = 0, offset = 0;
    const auto write = [&] {
      if (!waiting.empty()) file.write(offset, waiting);
      waiting.clear();
    };
    for (const Record& record : records) {
      const bool mine = at >= size / ranks * rank && (rank + 1 == ranks || at < size / ranks * (rank + 1));
      for (std::uint64_t done = 0; mine && done < record.length; done += bytes_at_once) {
        if (waiting.empty()) offset = at + done;
        waiting += parts[record.part].read(record.offset + done, std::min(bytes_at_once, record.length - done));
        if (waiting.size() >= bytes_at_once) write();
      }
      at += record.length;
    }
    write();
    file.flush();
  }
  MPI_Barrier(comm);
  if (rank == 0) std::filesystem::rename(partial, out);
}

}  // namespace graze::mpi
