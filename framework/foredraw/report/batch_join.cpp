#include <foredraw/report/batch_join.h>

#include <foredraw/report/private/json_values.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

bool BatchJoin::add(const std::string& text, const std::string& name, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    diagnostics.error({.file = name}, "bad-report", why, hint);
    return false;
  };
  const std::string what = "give the JSON reports of foredraw optimize for folders";
  std::vector<File> files;
  bool is_whole = true, is_known = true;
  const auto take = [&](const Json& file) {
    try {
      const Json& report = file.at("report");
      const auto outcome = outcome_called(file.at("outcome").get<std::string>());
      is_known = is_known && outcome;
      files.push_back({report.at("input").at("path").get<std::string>(), spool_.put(indented_text(report) + '\n'),
                       outcome.value_or(Outcome::lost), file.value("cached", false), name});
    } catch (const Json::exception&) {
      is_whole = false;  // which matters where it is a batch at all
    }
  };
  try {
    const Json head = parse_files(text, take);
    if (!head.contains("batch")) return refuse("is not the report of a folder", what);
    if (head["batch"] != 1) {
      return refuse(fmt::format("is of version {}, but this program reads version 1", head["batch"].dump()),
                    "use the program that wrote it");
    }
    if (!is_whole) return refuse("is incomplete", what);
    if (!is_known) return refuse("has an outcome that this program does not know", "use the program that wrote it");
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
  } catch (const Json::parse_error&) {
    return refuse("is not the report of a folder", what);
  } catch (const Json::exception&) {
    return refuse("is incomplete", what);
  }
  files_.insert(files_.end(), files.begin(), files.end());
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
