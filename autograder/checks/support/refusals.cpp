#include "checks/support/refusals.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "runner/text.hpp"

namespace mc::checks {
namespace {

bool is_refused(const Call& call) {
  return call.outcome.answered && call.outcome.status == wire::Status::invalid_argument;
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Whether the text contains this word or its plural, not only as a part of a longer word.
bool has_word(std::string_view text, std::string_view word) {
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    std::string_view rest = text.substr(at + word.size());
    if (rest.starts_with('s')) rest.remove_prefix(1);
    if ((at == 0 || !is_letter(text[at - 1])) && (rest.empty() || !is_letter(rest[0]))) return true;
  }
  return false;
}

}  // namespace

void expect_refused(const std::vector<InvalidCall>& calls) {
  for (const auto& [call, argument, because, rule] : calls) {
    if (is_refused(call)) continue;
    const auto& outcome = call.outcome;
    if (outcome.answered && outcome.status == wire::Status::todo) require_value(call);
    const bool is_value = outcome.answered && outcome.status == wire::Status::value;
    const std::string threw =
        outcome.status == wire::Status::out_of_range ? "std::out_of_range: " : "";
    fail(Failure{
        fmt::format("{} {}", call.text,
                    is_value           ? "returned a value"
                    : outcome.answered ? "threw " + threw + outcome.bytes
                                       : outcome.failure),
        "std::invalid_argument", because,
        is_value || !outcome.answered ? Likely{} : likely("wrong type of exception: {}", rule),
        rule});
  }
  pass();
}

void expect_argument_named(const std::vector<InvalidCall>& calls) {
  bool any_refused = false;
  for (const auto& [call, argument, because, rule] : calls) {
    if (!is_refused(call)) continue;
    any_refused = true;
    const std::string& text = call.outcome.bytes;
    const auto names = text::split(argument, '|');
    if (std::ranges::any_of(names, [&](auto name) { return has_word(text, name); })) continue;
    fail(Failure{fmt::format("{} threw std::invalid_argument(\"{}\")", call.text, text),
                 fmt::format("a message that names the argument: {}", fmt::join(names, " or ")),
                 because,
                 {},
                 "name the wrong argument in the exception's message"});
  }
  if (!any_refused) expect_refused(calls);
  pass();
}

}  // namespace mc::checks
