#include "grader/submission/intake.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/submission/archive.hpp"
#include "grader/submission/exports.hpp"
#include "grader/submission/source.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

using Files = std::map<std::string, fs::path>;  // lab name -> file

/// Limits of nesting and of the number of directories, beyond any real submission.
constexpr int deepest = 12;
constexpr std::size_t most_entries = 20'000;

/// The content of a directory, by name: directories, zips and other files; no links.
struct Listing {
  std::vector<fs::path> directories, zips, files, links;
};

Listing listing_of(const fs::path& directory) {
  Listing listing;
  std::vector<fs::directory_entry> entries;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (entries.size() == most_entries) {
      throw UnreadableSubmission(fmt::format("more than {} files in one directory", most_entries));
    }
    if (!is_ignored(entry.path().filename())) entries.push_back(entry);
  }
  std::ranges::sort(entries);
  for (const fs::directory_entry& entry : entries) {
    const fs::file_status status = entry.symlink_status();
    auto& kind = fs::is_symlink(status)         ? listing.links
                 : fs::is_directory(status)     ? listing.directories
                 : !fs::is_regular_file(status) ? listing.links  // a device: treated as a link
                 : entry.path().extension() == ".zip" ? listing.zips
                                                      : listing.files;
    kind.push_back(entry.path());
  }
  return listing;
}

/// Adds the files of every directory at or below `directory` that has lab files, but does not look
/// below those.
void search(const std::vector<Lab>& labs, const fs::path& directory, int depth, std::size_t& left,
            std::vector<Files>& places) {
  for (const fs::path& here : {directory, directory / "starter"}) {
    if (Files files = files_in(labs, here); !files.empty()) {
      places.push_back(std::move(files));
      return;
    }
  }
  if (depth == deepest) return;
  for (const fs::path& below : listing_of(directory).directories) {
    if (left-- == 0)
      throw UnreadableSubmission(fmt::format("more than {} directories", most_entries));
    search(labs, below, depth + 1, left, places);
  }
}

/// The path of `file` relative to `root`; empty for the root itself.
std::string place_in(const fs::path& root, const fs::path& file) {
  const fs::path place = file.parent_path().lexically_relative(fs::canonical(root));
  return place == "." ? "" : sandbox::printable_line(place.string());
}

/// The files of all places. Throws UnreadableSubmission if a file is in two of them.
Files combined(const fs::path& root, const std::vector<Files>& places) {
  Files all;
  for (const Files& files : places) {
    for (const auto& [lab, file] : files) {
      const auto [before, is_new] = all.emplace(lab, file);
      if (is_new) continue;
      throw UnreadableSubmission(fmt::format("{} is in {} and in {}: which one counts?",
                                             file.filename().string(),
                                             place_in(root, before->second), place_in(root, file)));
    }
  }
  return all;
}

bool looks_like_one_persons(const fs::path& directory) {
  for (const char* name : {".git", "README", "README.md", "CMakeLists.txt", "Makefile", "lab"}) {
    if (fs::exists(fs::symlink_status(directory / name))) return true;
  }
  return false;
}

/// The directory whose entries belong to several people: this one, or below it one that has no
/// sibling.
std::optional<fs::path> parent_in(const std::vector<Lab>& labs, fs::path directory) {
  for (int depth = 0; depth < deepest; ++depth) {
    if (!files_in(labs, directory).empty() || !files_in(labs, directory / "starter").empty() ||
        looks_like_one_persons(directory)) {
      return {};
    }
    const Listing listing = listing_of(directory);
    const bool is_flat = std::ranges::any_of(
        listing.files, [](auto& file) { return named_by_platform(file).has_value(); });
    if (!listing.zips.empty() || is_flat || listing.directories.size() > 1) return directory;
    if (listing.directories.empty()) return {};
    directory = listing.directories[0];
  }
  return {};
}

class IntakeBuilder {
 public:
  IntakeBuilder(const Context& context, Meaning meaning) : context_(context), meaning_(meaning) {}

  void add(const std::string& word) {
    // "alice/" and "." have names, too.
    const auto end = word.find_last_not_of('/');
    const fs::path place = end == std::string::npos ? word : word.substr(0, end + 1);
    add_entry(id_of(place), word, [&](IntakeEntry& entry) {
      const fs::file_status status = fs::symlink_status(place);
      const std::string shown = sandbox::printable_line(word);
      if (!fs::exists(status)) throw UnreadableSubmission("no such directory: " + shown);
      if (fs::is_symlink(status))
        throw UnreadableSubmission(shown + " is a link: name the directory itself");
      const bool is_zip = fs::is_regular_file(status) && place.extension() == ".zip";
      if (!is_zip && !fs::is_directory(status)) {
        throw UnreadableSubmission(shown + " is a file: name the directory it is in, or a zip");
      }
      const fs::path root = is_zip ? unpacked(place) : place;
      const auto parent = meaning_ == Meaning::many ? parent_in(context_.labs, root) : std::nullopt;
      if (!parent) return open(root, entry);
      add_people_in(*parent, is_zip);
      entry.submission.label.clear();  // belongs to no single person
    });
  }

  /// Decides what a word means, once for all words: several words are one submission each, so that
  /// a directory without an owner does not become people, unless platforms exported them all.
  void decide_meaning(const std::vector<std::string>& words) {
    if (meaning_ == Meaning::one || words.size() < 2) return;
    if (std::ranges::all_of(words, [&](auto& word) { return is_export(word); })) return;
    meaning_ = Meaning::one;
  }

  Intake finish() {
    make_labels_unique(intake_.entries);
    intake_.each_word_is_one = meaning_ == Meaning::one;
    return std::move(intake_);
  }

 private:
  static std::string id_of(const fs::path& place) {
    fs::path name = place.filename();
    if (name.empty() || name == "." || name == "..") {
      std::error_code unknown;
      name = fs::weakly_canonical(place, unknown).filename();
    }
    return id_from_name(name.extension() == ".zip" ? name.stem().string() : name.string());
  }

  /// Adds the result of `work` on `named`, or why it cannot be read.
  template <class Work>
  void add_entry(std::string id, const fs::path& named, const Work& work) {
    IntakeEntry entry;
    entry.submission.label = std::move(id);
    entry.submission.path = named;
    try {
      work(entry);
    } catch (const std::system_error& error) {
      if (is_machine_fault(error.code())) throw;
      entry.unreadable = error.code().message();
    } catch (const std::exception& error) {
      entry.unreadable = error.what();
    }
    if (!entry.submission.label.empty()) intake_.entries.push_back(std::move(entry));
  }

  /// Is there a platform's export of several people? False if it cannot be read.
  bool is_export(const std::string& word) {
    try {
      const fs::path place = word;
      fs::path root = place.extension() == ".zip" ? unpacked(place) : place;
      for (int depth = 0; depth < 2; ++depth) {
        const Listing listing = listing_of(root);
        const auto is_named = [](const fs::path& path) {
          return named_by_platform(path).has_value() ||
                 path.filename() == "submission_metadata.yml" ||
                 path.filename().string().find("_assignsubmission_") != std::string::npos;
        };
        for (const auto* kind : {&listing.directories, &listing.files, &listing.zips}) {
          if (std::ranges::any_of(*kind, is_named)) return true;
        }
        if (listing.directories.size() != 1) return false;
        root = listing.directories[0];
      }
    } catch (const std::exception&) {  // add() reports it
    }
    return false;
  }

  /// The directory of a zip's content.
  fs::path unpacked(const fs::path& zip) {
    if (const auto found = unpacked_.find(zip); found != unpacked_.end()) return found->second;
    if (fs::file_size(zip) == 0)
      throw UnreadableSubmission("the zip file is empty, or larger than 64 MB");
    intake_.unpacked.push_back(std::make_unique<ScratchDirectory>(context_.layout));
    unpack({.zip = zip, .to = intake_.unpacked.back()->path()});
    return unpacked_[zip] = intake_.unpacked.back()->path();
  }

  /// The only one of these zips; nothing if there is none.
  static std::optional<fs::path> only_zip(const std::vector<fs::path>& zips) {
    if (zips.size() > 1) throw UnreadableSubmission("several zip files: which one counts?");
    return zips.empty() ? std::nullopt : std::optional(zips[0]);
  }

  /// One person's work below `root`. A folder with nothing but a zip means that zip.
  void open(fs::path root, IntakeEntry& entry) {
    std::vector<Files> places = places_in(root);
    if (places.empty()) {
      if (const auto zip = only_zip(listing_of(root).zips)) {
        root = unpacked(*zip);
        places = places_in(root);
      }
    }
    set_files(root, places, entry);
  }

  std::vector<Files> places_in(const fs::path& root) const {
    std::vector<Files> places;
    std::size_t left = most_entries;
    search(context_.labs, root, 0, left, places);
    return places;
  }

  static void set_files(const fs::path& root, const std::vector<Files>& places,
                        IntakeEntry& entry) {
    entry.submission.files = combined(root, places);
    for (const auto& [lab, file] : entry.submission.files) {
      if (access(file.c_str(), R_OK) == 0) continue;
      throw UnreadableSubmission(fmt::format("{} cannot be read: {}", file.filename().string(),
                                             std::generic_category().message(errno)));
    }
    std::set<std::string> where;
    for (const auto& [lab, file] : entry.submission.files) where.insert(place_in(root, file));
    where.erase("");  // at the top
    entry.submission.found_in = fmt::format("{}", fmt::join(where, ", "));
  }

  /// One directory per person; Moodle has an online text as well as the files: take the one with
  /// the files.
  static std::map<std::string, fs::path> directories_by_person(const std::vector<fs::path>& all) {
    std::map<std::string, fs::path> chosen;
    for (const fs::path& directory : all) {
      const std::string id = id_of(directory), name = directory.filename().string();
      // Other names with the same id are other people.
      const bool is_moodles = name.find("_assignsubmission_") != std::string::npos;
      const std::string key = is_moodles ? id : name;
      const auto found = chosen.find(key);
      if (found == chosen.end() || is_moodle_text(found->second.filename().string())) {
        chosen[key] = directory;
      }
    }
    return chosen;
  }

  /// Several people's work, side by side in `parent`.
  void add_people_in(const fs::path& parent, bool is_unpacked) {
    const Listing listing = listing_of(parent);
    std::map<std::string, std::vector<PlatformName>> flat;  // by person
    for (const auto* kind : {&listing.files, &listing.zips}) {
      for (const fs::path& file : *kind) {
        if (const auto name = named_by_platform(file)) flat[name->person].push_back(*name);
      }
    }
    const auto named = [&](const fs::path& path) { return is_unpacked ? fs::path() : path; };
    const std::size_t first = intake_.entries.size();
    auto entries = gradescope_entries(parent);
    for (const auto& [key, directory] : directories_by_person(listing.directories)) {
      const std::string name = directory.filename().string();
      const GradescopeEntry& known = entries[name];
      add_entry(known.people.empty() ? id_of(directory) : id_from_name(known.people),
                named(directory), [&, &from = directory](IntakeEntry& entry) {
                  entry.submission.delivery.platform_name = name;
                  entry.submission.delivery.submitted = known.submitted;
                  open(from, entry);
                });
    }
    for (const fs::path& zip : listing.zips) {
      if (named_by_platform(zip)) continue;
      add_entry(id_of(zip), named(zip), [&](IntakeEntry& entry) { open(unpacked(zip), entry); });
    }
    for (const auto& [person, files] : flat) {
      add_entry(person, {}, [&, &all = files](IntakeEntry& entry) { collect(all, entry); });
    }
    for (const fs::path& link : listing.links) {
      add_entry(id_of(link), {}, [](IntakeEntry&) { throw UnreadableSubmission("it is a link"); });
    }
    std::stable_sort(intake_.entries.begin() + static_cast<std::ptrdiff_t>(first),
                     intake_.entries.end(),
                     [](auto& a, auto& b) { return a.submission.label < b.submission.label; });
  }

  /// One person's files among those of all.
  void collect(const std::vector<PlatformName>& files, IntakeEntry& entry) {
    std::map<std::string, PlatformName> latest;  // by lab
    for (const PlatformName& one : files) {
      for (const Lab& lab : context_.labs) {
        if (one.file != lab.file()) continue;
        const auto [before, is_new] = latest.emplace(lab.name, one);
        if (!is_new && one.attempt > before->second.attempt) before->second = one;
      }
    }
    Delivery& delivery = entry.submission.delivery;
    delivery.platform_name = files[0].path.filename().string();
    delivery.late = files[0].late;
    std::vector<Files> places;
    for (const auto& [lab, one] : latest) {
      places.push_back({{lab, fs::canonical(one.path)}});
      delivery.platform_name = one.path.filename().string();
      delivery.late = one.late;
    }
    if (!places.empty()) return set_files(files[0].path.parent_path(), places, entry);
    std::vector<fs::path> zips;
    for (const PlatformName& one : files) {
      if (one.path.extension() == ".zip") zips.push_back(one.path);
    }
    if (const auto zip = only_zip(zips)) open(unpacked(*zip), entry);
  }

  const Context& context_;
  Meaning meaning_;
  Intake intake_;
  std::map<fs::path, fs::path> unpacked_;  ///< zip -> the directory of its content
};

}  // namespace

std::string in_lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

void make_labels_unique(std::vector<IntakeEntry>& entries) {
  std::set<std::string> taken;
  for (IntakeEntry& entry : entries) {
    std::string& label = entry.submission.label;
    const std::string plain = label;
    for (int i = 2; !taken.insert(in_lower_case(label)).second; ++i) {
      label = fmt::format("{} ({})", plain, i);
    }
  }
}

Intake take_in(const Context& context, const std::vector<std::string>& words, Meaning meaning) {
  IntakeBuilder builder(context, meaning);
  builder.decide_meaning(words);
  for (const std::string& word : words) builder.add(word);
  return builder.finish();
}

Intake take_in_one(const Context& context, const fs::path& place) {
  Intake intake = take_in(context, {place.string()}, Meaning::one);
  if (!intake.entries[0].unreadable.empty()) throw UsageError(intake.entries[0].unreadable);
  return intake;
}

}  // namespace mc::grader
