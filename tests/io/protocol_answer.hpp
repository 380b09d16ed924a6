// One line of the query protocol asked, and its answer read.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include <nlohmann/json.hpp>

#include "graze/io/protocol.hpp"

namespace graze::io {

/// Expects that the answer says `error` where it is said to be one.
inline nlohmann::json ask(const std::string& line, Precision precision = Precision::double_precision) {
  const AnswerLine answer = answer_line(line, precision);
  const nlohmann::json json = nlohmann::json::parse(answer.text);
  EXPECT_EQ(json.contains("error"), answer.error);
  return json;
}

}  // namespace graze::io
