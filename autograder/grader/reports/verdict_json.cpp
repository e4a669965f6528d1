#include "grader/reports/verdict_json.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  static void to_json(ordered_json& json, const std::optional<T>& value) {
    json = value ? ordered_json(*value) : ordered_json(nullptr);
  }
  static void from_json(const ordered_json& json, std::optional<T>& value) {
    value = json.is_null() ? std::nullopt : std::optional(json.get<T>());
  }
};

namespace mc::grader {

using Json = nlohmann::ordered_json;

/// Increment when the content of a verdict changes: older ones are then judged again.
constexpr int verdict_format = 3;

/// Keys that verdicts of version 1.0 lack.
constexpr std::string_view newer_keys[] = {"delivery", "hours", "on_reference"};

/// In the order of Status.
constexpr std::string_view status_names[] = {"passed",  "failed",  "not written", "withheld",
                                             "waiting", "not run", "not judged",  "internal error"};

void to_json(Json& json, Status status) {
  json = status_names[static_cast<std::size_t>(status)];
}
void from_json(const Json& json, Status& status) {
  const auto found = std::ranges::find(status_names, json.get<std::string>());
  if (found == std::end(status_names)) throw std::invalid_argument("no such status");
  status = static_cast<Status>(found - std::begin(status_names));
}

// The keys and the fields of each struct, in one list for writing and reading.

template <class Field>
void fields(Lab& lab, Field field) {
  field("number", lab.number);
  field("name", lab.name);
  field("folder", lab.folder);
  field("depends_on", lab.depends_on);
}

template <class Field>
void fields(CheckResult& result, Field field) {
  field("name", result.check.name);
  field("task", result.check.task);
  field("needs", result.check.needs);
  field("points", result.check.points);
  field("main", result.check.is_main);
  field("edge", result.check.is_edge);
  field("status", result.status);
  field("report", result.report);
  field("printed", result.printed);
  field("repeat", result.repeat);
  field("by_hand", result.by_hand);
  field("seconds", result.seconds);
}

template <class Field>
void fields(Speed& speed, Field field) {
  field("name", speed.name);
  field("nanoseconds", speed.nanoseconds);
  field("plain", speed.plain);
  field("noise", speed.noise);
  field("error", speed.error);
  field("points", speed.points);
  field("integrand", speed.integrand);
}

template <class Field>
void fields(Delivery& delivery, Field field) {
  field("name", delivery.name);
  field("email", delivery.email);
  field("submitted", delivery.submitted);
  field("late", delivery.late);
  field("platform_name", delivery.platform_name);
  field("hours", delivery.hours);
}

template <class Field>
void fields(LabVerdict& lab, Field field) {
  double earned = lab.earned(), points = lab.points();  // for people and scripts: not read back
  field("lab", lab.lab);
  field("earned", earned);
  field("points", points);
  field("no_program", lab.no_program);
  field("unfinished", lab.unfinished);
  field("seconds", lab.seconds);
  field("checks", lab.checks);
  field("speed", lab.speed);
  field("on_reference", lab.on_reference);
}

/// Without its contents, which are not UTF-8.
template <class Field>
void fields(Verdict& verdict, Field field) {
  field("submission", verdict.submission);
  field("found_in", verdict.found_in);
  field("delivery", verdict.delivery);
  field("seed", verdict.seed);
  field("version", verdict.version);
  field("flags", verdict.flags);
  field("jail_complete", verdict.jail_complete);
  field("not_judged", verdict.not_judged);
  field("unreadable", verdict.unreadable);
  field("absent", verdict.absent);
  field("seconds", verdict.seconds);
  field("labs", verdict.labs);
}

template <class T>
concept HasFields = requires(T& value) {
  fields(value, [](const char*, auto&) {});
};

template <HasFields T>
void to_json(Json& json, const T& value) {
  fields(const_cast<T&>(value), [&](const char* key, const auto& field) { json[key] = field; });
}
template <HasFields T>
void from_json(const Json& json, T& value) {
  fields(value, [&](const char* key, auto& field) {
    const bool is_newer = std::ranges::find(newer_keys, key) != std::end(newer_keys);
    if (!is_newer || json.contains(key)) json.at(key).get_to(field);
  });
}

namespace {

/// JSON is UTF-8, and a source file may have any bytes: each becomes the code point of its value.
std::string bytes_as_utf8(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xc0 | byte >> 6);
      text += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return text;
}
std::string bytes_in_utf8(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_pair = byte >= 0x80 && i + 1 < text.size();
    bytes += is_pair ? static_cast<char>((byte & 0x03) << 6 | (text[++i] & 0x3f)) : text[i];
  }
  return bytes;
}

}  // namespace

std::string verdict_to_json(const Verdict& verdict) {
  Json json = verdict;
  json["format"] = verdict_format;
  json["contents"] = bytes_as_utf8(verdict.contents);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Verdict verdict_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  if (json.at("format") != verdict_format) throw std::invalid_argument("another format");
  Verdict verdict = json;
  verdict.contents = bytes_in_utf8(json.at("contents").get<std::string>());
  return verdict;
}

}  // namespace mc::grader
