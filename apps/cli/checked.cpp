#include "checked.hpp"

#include <charconv>
#include <filesystem>

#include "graze/detail/validate.hpp"

namespace graze::cli {

io::Precision precision_of(const std::string& name) {
  return name == "float" ? io::Precision::single_precision : io::Precision::double_precision;
}

std::size_t checked_count(const char* option, const std::string& text) {
  std::size_t count = 0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, count);
  if (error == std::errc::result_out_of_range && last == end)
    throw InvalidValue(option, "a whole number of at most 19 digits", text);
  if (error != std::errc{} || last != end || count < 1) throw InvalidValue(option, "a whole number >= 1", text);
  return count;
}

double checked_length(const char* option, double value, io::Precision precision) {
  const char* fault = precision == io::Precision::single_precision
                          ? validate::fault_of_length(static_cast<float>(value))
                          : validate::fault_of_length(value);
  if (fault) validate::fail(option, fault, value);
  return value;
}

Vec3d checked_direction(const std::vector<double>& numbers) {
  const Vec3d direction = validate::point(Vec3d{numbers.at(0), numbers.at(1), numbers.at(2)}, "--direction");
  if (direction == Vec3d{}) throw InvalidValue("--direction", "a direction that is not zero", "0, 0, 0");
  return direction;
}

void check_ending(const char* option, const std::string& file, const std::string& ending) {
  if (file.empty() || file.ends_with(ending)) return;
  std::error_code failed;
  if (std::filesystem::exists(file, failed) && !std::filesystem::is_regular_file(file, failed) &&
      !std::filesystem::is_directory(file, failed))
    return;
  throw InvalidValue(option, "a file name that ends in " + ending, file);
}

void check_output(const char* option, const std::string& file, std::span<const std::string> inputs) {
  if (file.empty()) return;
  for (const std::string& input : inputs) {
    std::error_code failed;  // of a file that is not there yet
    if (std::filesystem::is_regular_file(file, failed) && std::filesystem::equivalent(file, input, failed) && !failed)
      throw InvalidValue(option, "another file than the one that is read", file);
  }
}

void throw_renamed(const InvalidValue& e, OptionNames names) {
  for (const auto& [own, option] : names)
    if (e.path() == own || e.path().starts_with(std::string(own) + "["))
      throw InvalidValue(option + e.path().substr(std::string(own).size()), e.expectation(), e.found());
  throw;
}

}  // namespace graze::cli
