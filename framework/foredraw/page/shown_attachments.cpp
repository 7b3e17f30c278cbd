#include <foredraw/page/private/shown_attachments.h>

#include <foredraw/page/private/page_buffer.h>

#include <foredraw/base/content_hash.h>
#include <foredraw/io/image/picture.h>
#include <foredraw/report/attachment_json.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

/// What one technique attached to one state of a file, of as many frames. `place`: 0 is the input, i + 1 branch i.
struct State {
  std::size_t place = 0;
  std::vector<const AttachmentRecord*> attachments;
};

/// What the script shows with one slider.
struct Group {
  std::string use;
  std::size_t frames = 0;
  std::vector<State> states;
};

class EncodedPictures {
 public:
  explicit EncodedPictures(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// The numbers of a film's pictures; nothing where there is no room for them all, or where they were let go.
  std::vector<std::size_t> add(const Film& film) {
    std::vector<std::size_t> numbers;
    std::map<Key, std::size_t> fresh;
    std::vector<std::string> made;
    std::size_t bytes = bytes_;
    for (const std::vector<std::uint8_t>& frame : film.frames) {
      if (frame.empty()) return {};
      const Key key{film.width, film.height, content_hash(std::span(frame))};
      if (const auto known = numbers_.find(key); known != numbers_.end()) {
        numbers.push_back(known->second);
        continue;
      }
      const auto [place, is_new] = fresh.try_emplace(key, encoded_.size() + made.size());
      numbers.push_back(place->second);
      if (!is_new) continue;
      made.push_back(base64(images::png_of_pixels(film.width, film.height, frame)));
      bytes += made.back().size();
      if (bytes > most_bytes_) return {};
    }
    bytes_ = bytes;
    numbers_.merge(fresh);
    std::ranges::move(made, std::back_inserter(encoded_));
    return numbers;
  }

  std::vector<std::string> take() { return std::move(encoded_); }

 private:
  using Key = std::tuple<int, int, Stamp>;

  std::map<Key, std::size_t> numbers_;
  std::vector<std::string> encoded_;
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
};

void add(std::vector<Group>& groups, const std::string& use, std::size_t place,
         const std::vector<AttachmentRecord>& attachments) {
  for (const AttachmentRecord& attachment : attachments) {
    const std::size_t frames = frames_of(*attachment.content);
    auto group = std::ranges::find_if(groups, [&](const Group& g) { return g.use == use && g.frames == frames; });
    if (group == groups.end()) group = groups.insert(groups.end(), {use, frames, {}});
    auto state = std::ranges::find(group->states, place, &State::place);
    if (state == group->states.end()) state = group->states.insert(state, {place, {}});
    state->attachments.push_back(&attachment);
  }
}

/// What evaluators attached first: stages are many.
std::vector<Group> groups_of(const Comparison& comparison) {
  std::vector<Group> groups;
  const auto whole = std::ranges::find(comparison.branches, false, &Branch::is_lost);
  if (whole == comparison.branches.end()) return groups;
  for (const StageRecord& measure : whole->report.measures) add(groups, measure.use, 0, measure.attachments_before);
  for (const auto& records : {&Report::measures, &Report::stages}) {
    for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
      for (const StageRecord& record : comparison.branches[i].report.*records) {
        add(groups, record.use, i + 1, record.attachments);
      }
    }
  }
  return groups;
}

Json json_of(const AttachmentRecord& attachment, EncodedPictures& pictures) {
  Json json = Json::parse(to_json(attachment));
  if (const Film* film = std::get_if<Film>(attachment.content.get())) json["pictures"] = pictures.add(*film);
  return json;
}

Json json_of(const Group& group, std::size_t file, EncodedPictures& pictures) {
  Json states = Json::array();
  for (const State& state : group.states) {
    Json attachments = Json::array();
    for (const AttachmentRecord* attachment : state.attachments) attachments.push_back(json_of(*attachment, pictures));
    states.push_back({{"place", state.place}, {"attachments", std::move(attachments)}});
  }
  return {{"file", file}, {"use", group.use}, {"frames", group.frames}, {"states", std::move(states)}};
}

}  // namespace

ShownAttachments shown_attachments(std::span<const Comparison> comparisons, std::size_t most_bytes) {
  EncodedPictures pictures(most_bytes);
  Json groups = Json::array();
  for (std::size_t file = 0; file < std::min(comparisons.size(), most_displays); ++file) {
    for (const Group& group : groups_of(comparisons[file])) groups.push_back(json_of(group, file, pictures));
  }
  if (groups.empty()) return {};
  return {Json{{"groups", std::move(groups)}}.dump(-1, ' ', false, Json::error_handler_t::replace), pictures.take()};
}

}  // namespace foredraw
