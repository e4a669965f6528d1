#include "judge/reports/verdict_json.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace mc::grader {

/// Increment when the content of a verdict changes: older ones are then judged again.
constexpr int verdict_format = 3;

// The first name is what an unknown one is read as.
NLOHMANN_JSON_SERIALIZE_ENUM(Status, {{Status::internal_error, "internal error"},
                                      {Status::passed, "passed"},
                                      {Status::failed, "failed"},
                                      {Status::not_written, "not written"},
                                      {Status::withheld, "withheld"},
                                      {Status::waiting, "waiting"},
                                      {Status::not_run, "not run"},
                                      {Status::not_judged, "not judged"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Lab, number, name, folder, depends_on)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Check, name, task, needs, points, is_main, is_edge)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckResult, check, status, report, printed, repeat, by_hand,
                                   seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LabVerdict, lab, checks, no_program, unfinished, seconds,
                                   on_reference)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Verdict, submission, found_in, contents, seed, version, flags,
                                   jail_complete, reads_confined, not_judged, unreadable, labs,
                                   absent, others, seconds)

std::string verdict_to_json(const Verdict& verdict) {
  nlohmann::json json = verdict;
  json["format"] = verdict_format;
  for (std::size_t i = 0; i < verdict.labs.size(); ++i) {  // for scripts: not read again
    json["labs"][i]["earned"] = verdict.labs[i].earned();
    json["labs"][i]["points"] = verdict.labs[i].points();
  }
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

Verdict verdict_from_json(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  if (json.at("format") != verdict_format) throw std::invalid_argument("another format");
  return json.get<Verdict>();
}

}  // namespace mc::grader
