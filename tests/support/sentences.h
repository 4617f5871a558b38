#pragma once

#include <gmock/gmock.h>
#include <stdexcept>
#include <string>

namespace mres::test {

/// A call that throws an Error whose text is a sentence with `part` in it.
template <class Error = std::invalid_argument>
auto refusesInASentence(const std::string& part = "") {
  using testing::AllOf;
  using testing::ContainsRegex;
  using testing::HasSubstr;
  return testing::ThrowsMessage<Error>(AllOf(ContainsRegex("^[A-Z].* .*\\.$"), HasSubstr(part)));
}

}  // namespace mres::test
