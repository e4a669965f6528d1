#pragma once
// Objects and programs from earlier builds. A hash only names a file, and texts can be made to fit
// it: what is found was made of exactly the same text, flags and headers.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mc::grader {

/// What was kept in `slot` for this key, the whole text that it depends on; it stays for another
/// hour. Nothing where there is none.
std::optional<std::filesystem::path> find_cached(const std::filesystem::path& slot,
                                                 std::string_view kind, const std::string& key);

/// Moves `made` into the slot, under a name that no other file has, and removes what has not been
/// used for an hour. Throws std::system_error on a full disk.
std::filesystem::path keep_cached(const std::filesystem::path& slot, std::string_view kind,
                                  const std::string& key, const std::filesystem::path& made);

}  // namespace mc::grader
