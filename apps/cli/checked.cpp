#include "checked.hpp"

#include "graze/validate.hpp"

namespace graze::cli {

io::Precision precision_of(const std::string& name) {
  return name == "float" ? io::Precision::single_precision : io::Precision::double_precision;
}

double checked_margin(double margin, io::Precision precision) {
  const char* fault = precision == io::Precision::single_precision
                          ? validate::fault_of_length(static_cast<float>(margin))
                          : validate::fault_of_length(margin);
  if (fault) validate::fail("--margin", fault, margin);
  return margin;
}

Vec3d checked_direction(const std::vector<double>& numbers) {
  const Vec3d direction = validate::point(Vec3d{numbers.at(0), numbers.at(1), numbers.at(2)}, "--direction");
  if (direction == Vec3d{}) throw InvalidValue("--direction", "a direction that is not zero", "0, 0, 0");
  return direction;
}

}  // namespace graze::cli
