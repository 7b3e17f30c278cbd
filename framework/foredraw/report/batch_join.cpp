#include <foredraw/report/batch_join.h>

#include <foredraw/report/private/json_places.h>
#include <foredraw/report/private/json_values.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

/// Of everything but the files; null where the text is no JSON object.
Json head_of(const std::string& text) {
  if (!Json::accept(text)) return nullptr;
  Json head = Json::object();
  for (const auto& [key, value] : members_in(text)) {
    if (key != "files") head[std::string(key)] = Json::parse(value);
  }
  return head;
}

}  // namespace

bool BatchJoin::add(const std::string& text, const std::string& name, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    diagnostics.error({.file = name}, "bad-report", why, hint);
    return false;
  };
  const std::string what = "give the JSON reports of foredraw optimize for folders";
  const Json head = head_of(text);
  if (!head.is_object() || !head.contains("batch")) return refuse("is not the report of a folder", what);
  if (head["batch"] != 1) {
    return refuse(fmt::format("is of version {}, but this program reads version 1", head["batch"].dump()),
                  "use the program that wrote it");
  }
  try {
    const auto command = head.at("command").get<std::string>();
    if (!command_.empty() && command != command_) {
      return refuse(fmt::format("is of '{}', but those before are of '{}'", command, command_), what);
    }
    command_ = command;
    seconds_ += head.at("seconds").get<double>();
    if (head.contains("shard")) {
      const auto of = head["shard"].at("of").get<std::uint32_t>();
      if (of_ != 0 && of != of_) {
        return refuse(fmt::format("is one of {} parts, but those before are of {}", of, of_),
                      "give the parts of one run alone");
      }
      of_ = of;
      const auto number = head["shard"].at("number").get<std::uint32_t>();
      if (!numbers_.insert(number).second) {
        return refuse(fmt::format("is part {}, which came before", number), "give each part once");
      }
    }
    for (const auto& [key, value] : members_in(text)) {
      if (key != "files") continue;
      for (const std::string_view element : elements_in(value)) {
        const Json file = Json::parse(element);
        const Json& report = file.at("report");
        const auto outcome = outcome_called(file.at("outcome").get<std::string>());
        if (!outcome) return refuse("has an outcome that this program does not know", "use the program that wrote it");
        files_.push_back({report.at("input").at("path").get<std::string>(),
                          spool_.put(report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'), *outcome,
                          file.value("cached", false), name});
      }
    }
  } catch (const Json::exception&) {
    return refuse("is incomplete", what);
  }
  std::ranges::stable_sort(files_, {}, &File::path);
  const auto twin = std::ranges::adjacent_find(files_, {}, &File::path);
  if (twin == files_.end()) return true;
  return refuse(fmt::format("holds '{}', which '{}' holds too", twin->path.string(), twin->part),
                "give each part once");
}

bool BatchJoin::is_whole(Diagnostics& diagnostics) const {
  std::vector<std::uint32_t> missing;
  for (std::uint32_t number = 1; number <= of_; ++number) {
    if (!numbers_.contains(number)) missing.push_back(number);
  }
  if (missing.empty()) return true;
  diagnostics.warning({}, "part-missing",
                      fmt::format("of {} parts these are missing: {}", of_, fmt::join(missing, ", ")),
                      "run them again with --shard, and join all");
  return false;
}

void BatchJoin::put_into(Batch& batch) const {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    batch.add(i, spool_.get(files_[i].report), files_[i].outcome, files_[i].from_cache);
  }
}

}  // namespace foredraw
