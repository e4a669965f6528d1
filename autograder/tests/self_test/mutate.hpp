#pragma once
// Mutations of C++ source text: one small change each, similar to a student's slip.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mc::self_test {

/// Replaces `length` characters at `offset` by `replacement`.
struct Mutation {
  std::size_t offset, length;
  std::string replacement;
};

/// All mutations of the code between braces: operators and comparisons exchanged, constants plus
/// and minus one, conditions negated, casts dropped, double to float, 64 to 32 bits, statements
/// removed, arguments exchanged, `static` added. Comments, strings and preprocessor lines stay.
/// The spaces that clang-format sets distinguish tokens: `a < b` compares, `span<double>` does not.
std::vector<Mutation> mutations_of(std::string_view source);

/// The source with one mutation.
std::string mutated(std::string_view source, const Mutation& mutation);

/// The line that a mutation changes, before and after, without indentation: "a + b; => a - b;".
std::string description(std::string_view source, const Mutation& mutation);

}  // namespace mc::self_test
