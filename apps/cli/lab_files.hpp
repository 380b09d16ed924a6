// The files that `graze view` serves: those of the built lab, and one file to look at, with all that belongs to it.
//
// Guarantee: nothing else of the disk, whatever a request says: a request names an entry of a table that was made
// at the start, or nothing. Answers only requests that the lab's own page makes, or the person who types its
// address. Safe from any thread.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "shown_file.hpp"

namespace graze::cli {

/// The fields of a request that count. Fields that it did not have are empty.
struct LabRequest {
  std::string method, path;
  std::string host, origin;
  std::string fetch_site;     ///< where the request comes from, by the browser (`Sec-Fetch-Site`)
  std::string if_none_match;  ///< the version that the browser has
};

struct LabAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string version;  ///< of the file that is looked at, else empty
  std::string body;
};

class LabFiles {
 public:
  /// Reads the lab's files now, and `shown` at each request for it. Throws `InvalidValue` when `lab` holds no lab or
  /// `shown` is no file that can be read.
  LabFiles(const std::filesystem::path& lab, std::filesystem::path shown);

  /// Answers a request to the server at `port` of this machine.
  LabAnswer answer(const LabRequest& request, int port) const;

  /// The path of the page that shows the file, from the server's root.
  std::string page() const;

 private:
  struct File {
    std::string type, content;
  };

  LabAnswer shown_file(const LabRequest& request) const;

  std::map<std::string, File, std::less<>> files_;  ///< by the paths of requests
  ShownFile shown_;
  std::string shown_path_;
};

/// The folder of the built lab: `given` if that is not empty, else beside the installed program, else where this tree
/// builds it. Throws `InvalidValue` where none is, with the command that builds it.
std::filesystem::path find_lab(const std::string& given);

}  // namespace graze::cli
