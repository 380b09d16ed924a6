#include "lab_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graze/error.hpp"

namespace graze::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_lab_file = std::size_t{64} << 20;

std::string type_of(const fs::path& file) {
  constexpr std::array<std::pair<const char*, const char*>, 8> types{{{".html", "text/html; charset=utf-8"},
                                                                      {".js", "text/javascript; charset=utf-8"},
                                                                      {".css", "text/css; charset=utf-8"},
                                                                      {".wasm", "application/wasm"},
                                                                      {".svg", "image/svg+xml"},
                                                                      {".png", "image/png"},
                                                                      {".json", "application/json"},
                                                                      {".txt", "text/plain; charset=utf-8"}}};
  const std::string ending = file.extension().string();
  const auto found = std::find_if(types.begin(), types.end(), [&](const auto& type) { return ending == type.first; });
  return found == types.end() ? "application/octet-stream" : found->second;
}

/// Bytes that may stand in a path of an address as they are; all others by their numbers.
std::string in_address(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                       c == '-' || c == '.' || c == '_' || c == '~';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return out;
}

LabAnswer refusal(int status, const std::string& why) { return {status, "text/plain; charset=utf-8", "", why + "\n"}; }

}  // namespace

LabFiles::LabFiles(const fs::path& lab, fs::path shown) : shown_(std::move(shown)) {
  shown_path_ = "/file/" + shown_.path().filename().string();
  std::error_code problem;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(lab, problem)) {
    // A link could lead out of the folder.
    if (!fs::is_regular_file(entry.symlink_status())) continue;
    if (entry.file_size() > largest_lab_file)
      throw InvalidValue(entry.path().string(), "a file of the lab", fmt::format("{} bytes", entry.file_size()));
    files_.emplace("/" + fs::relative(entry.path(), lab).generic_string(),
                   File{type_of(entry.path()), bytes_of(entry.path())});
  }
  const auto index = files_.find("/index.html");
  if (index == files_.end())
    throw InvalidValue(lab.string(), "a folder with the built lab (make lab)", "no index.html");
  files_.emplace("/", index->second);
}

LabAnswer LabFiles::answer(const LabRequest& request, int port) const {
  // The browser's headers reveal names that another site made to lead here, and requests of other sites' pages.
  const std::string here = fmt::format("127.0.0.1:{}", port), named = fmt::format("localhost:{}", port);
  if (request.host != here && request.host != named) return refusal(403, "Not the address of this server");
  if (!request.origin.empty() && request.origin != "http://" + request.host)
    return refusal(403, "Other sites have no access");
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none")
    return refusal(403, "Other sites have no access");
  if (request.method != "GET" && request.method != "HEAD") return refusal(405, "Only GET and HEAD");
  if (request.path == shown_path_) return shown_file(request);
  const auto file = files_.find(request.path);
  if (file == files_.end()) return refusal(404, "There is nothing here");
  return {200, file->second.type, "", file->second.content};
}

LabAnswer LabFiles::shown_file(const LabRequest& request) const try {
  if (!shown_.is_there()) return refusal(404, "The file is gone");
  const std::string version = "\"" + shown_.version() + "\"", type = type_of(shown_.path());
  if (request.if_none_match == version) return {304, type, version, ""};
  return {200, type, version, shown_.content()};
} catch (const std::exception&) {
  return refusal(404, "The file is gone");
}

std::string LabFiles::page() const {
  return "/#/scene?file=" + in_address("file/" + in_address(shown_.path().filename().string()));
}

fs::path find_lab(const std::string& given) {
  if (!given.empty()) return given;
  std::error_code problem;
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  for (const fs::path& lab : {program.parent_path().parent_path() / "share/graze/lab", fs::path(GRAZE_LAB_BUILT)})
    if (fs::is_regular_file(lab / "index.html", problem)) return lab;
  throw InvalidValue("the lab", "built by make lab, or named by --lab", "not found");
}

}  // namespace graze::cli
