#pragma once
// Objects and programs from earlier builds. The hash only names a file and may collide: a hit must
// have been built from exactly the same text, flags and headers.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mc::grader {

/// The cached file in `slot` for this key, the full text that it depends on; renews it for an hour.
/// Nothing if there is none.
std::optional<std::filesystem::path> find_cached(const std::filesystem::path& slot,
                                                 std::string_view kind, const std::string& key);

/// Moves `made` into the slot under a unique name, and removes files that have not been used for an
/// hour. Throws std::system_error on a full disk.
std::filesystem::path keep_cached(const std::filesystem::path& slot, std::string_view kind,
                                  const std::string& key, const std::filesystem::path& made);

}  // namespace mc::grader
