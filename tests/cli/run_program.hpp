// The program run as by a person, with what it prints.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace graze::cli {

struct Result {
  int code;
  std::string output;
};

/// Runs the program in a shell: both its outputs together, and the exit code of the last of a pipeline. `before` is
/// what comes first on the line.
inline Result run(const std::string& arguments, const std::string& before = "") {
  const std::string command = before + GRAZE_CLI_PATH + " 2>&1 " + arguments;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string output;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) output.append(part.data(), n);
  return {WEXITSTATUS(pclose(pipe)), output};
}

}  // namespace graze::cli
