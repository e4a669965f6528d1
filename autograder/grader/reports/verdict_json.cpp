#include "grader/reports/verdict_json.hpp"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace mc::grader {
namespace {

using Json = nlohmann::ordered_json;

/// Increment when the content of a verdict changes: older ones are then judged again.
constexpr int verdict_format = 2;

constexpr std::array<std::pair<Status, const char*>, 8> status_names{{
    {Status::passed, "passed"},
    {Status::failed, "failed"},
    {Status::not_written, "not written"},
    {Status::withheld, "withheld"},
    {Status::waiting, "waiting"},
    {Status::not_run, "not run"},
    {Status::not_judged, "not judged"},
    {Status::internal_error, "internal error"},
}};

const char* name_of(Status status) {
  for (const auto& [one, name] : status_names) {
    if (one == status) return name;
  }
  return "internal error";
}

Status status_named(const std::string& text) {
  for (const auto& [one, name] : status_names) {
    if (name == text) return one;
  }
  throw std::invalid_argument("no such status: " + text);
}

Json maybe(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}
std::optional<double> maybe_in(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

Json json_of(const Lab& lab) {
  return {{"number", lab.number},
          {"name", lab.name},
          {"folder", lab.folder},
          {"depends_on", lab.depends_on}};
}
Lab lab_in(const Json& json) {
  return {json.at("number"), json.at("name"), json.at("folder"), json.at("depends_on")};
}

Json json_of(const CheckResult& result) {
  const Check& check = result.check;
  return {{"name", check.name},
          {"task", check.task},
          {"needs", check.needs},
          {"points", check.points},
          {"main", check.is_main},
          {"edge", check.is_edge},
          {"status", name_of(result.status)},
          {"report", result.report},
          {"printed", result.printed},
          {"repeat", result.repeat},
          {"by_hand", result.by_hand},
          {"seconds", result.seconds}};
}
CheckResult check_in(const Json& json) {
  CheckResult result;
  result.check = {json.at("name"),   json.at("task"), json.at("needs"),
                  json.at("points"), json.at("main"), json.at("edge")};
  result.status = status_named(json.at("status"));
  result.report = json.at("report");
  result.printed = json.at("printed");
  result.repeat = json.at("repeat");
  result.by_hand = json.at("by_hand");
  result.seconds = json.at("seconds");
  return result;
}

Json json_of(const Speed& speed) {
  return {{"name", speed.name},
          {"nanoseconds", speed.nanoseconds},
          {"reference", maybe(speed.reference)},
          {"is_estimate", speed.is_estimate},
          {"error", maybe(speed.error)},
          {"reference_error", maybe(speed.reference_error)},
          {"points", speed.points},
          {"integrand", speed.integrand},
          {"addition", speed.addition}};
}
Speed speed_in(const Json& json) {
  return {json.at("name"),
          json.at("nanoseconds"),
          maybe_in(json.at("reference")),
          json.value("is_estimate", false),
          maybe_in(json.at("error")),
          maybe_in(json.at("reference_error")),
          json.at("points"),
          json.at("integrand"),
          json.value("addition", 0.0)};
}

Json json_of(const Delivery& delivery) {
  return {{"name", delivery.name},
          {"email", delivery.email},
          {"submitted", delivery.submitted},
          {"late", delivery.late},
          {"platform_name", delivery.platform_name},
          {"hours", delivery.hours}};
}
Delivery delivery_in(const Json& json) {
  return {json.at("name"),          json.at("email"),
          json.at("submitted"),     json.at("late"),
          json.at("platform_name"), json.value("hours", std::map<std::string, std::string>())};
}

Json json_of(const LabVerdict& lab) {
  auto checks = Json::array(), speed = Json::array();
  for (const CheckResult& result : lab.checks) checks.push_back(json_of(result));
  for (const Speed& one : lab.speed) speed.push_back(json_of(one));
  // "earned" is for people and scripts; the grader does not read it back.
  return {{"lab", json_of(lab.lab)},         {"earned", lab.earned()},
          {"points", lab.points()},          {"no_program", lab.no_program},
          {"unfinished", lab.unfinished},    {"seconds", lab.seconds},
          {"checks", std::move(checks)},     {"speed", std::move(speed)},
          {"on_reference", lab.on_reference}};
}
LabVerdict lab_verdict_in(const Json& json) {
  LabVerdict lab;
  lab.lab = lab_in(json.at("lab"));
  lab.no_program = json.at("no_program");
  lab.unfinished = json.at("unfinished").get<std::vector<std::string>>();
  lab.seconds = json.at("seconds");
  for (const Json& one : json.at("checks")) lab.checks.push_back(check_in(one));
  for (const Json& one : json.at("speed")) lab.speed.push_back(speed_in(one));
  lab.on_reference = json.value("on_reference", std::vector<std::string>());
  return lab;
}

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
  auto labs = Json::array();
  for (const LabVerdict& lab : verdict.labs) labs.push_back(json_of(lab));
  const Json all{{"format", verdict_format},
                 {"submission", verdict.submission},
                 {"found_in", verdict.found_in},
                 {"delivery", json_of(verdict.delivery)},
                 {"contents", bytes_as_utf8(verdict.contents)},
                 {"seed", verdict.seed},
                 {"version", verdict.version},
                 {"flags", verdict.flags},
                 {"jail_complete", verdict.jail_complete},
                 {"not_judged", verdict.not_judged},
                 {"unreadable", verdict.unreadable},
                 {"absent", verdict.absent},
                 {"seconds", verdict.seconds},
                 {"labs", std::move(labs)}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Verdict verdict_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  if (json.at("format") != verdict_format) throw std::invalid_argument("another format");
  Verdict verdict;
  verdict.submission = json.at("submission");
  verdict.found_in = json.at("found_in");
  if (json.contains("delivery")) verdict.delivery = delivery_in(json.at("delivery"));
  verdict.contents = bytes_in_utf8(json.at("contents").get<std::string>());
  verdict.seed = json.at("seed");
  verdict.version = json.at("version");
  verdict.flags = json.at("flags");
  verdict.jail_complete = json.at("jail_complete");
  verdict.not_judged = json.at("not_judged");
  verdict.unreadable = json.at("unreadable");
  verdict.absent = json.at("absent").get<std::vector<std::string>>();
  verdict.seconds = json.at("seconds");
  for (const Json& lab : json.at("labs")) verdict.labs.push_back(lab_verdict_in(lab));
  return verdict;
}

}  // namespace mc::grader
