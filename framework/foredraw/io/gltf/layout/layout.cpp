#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/private/rows.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr std::size_t greatest_stride = 252;

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// Users whose bytes overlap: rows of one vertex buffer, or something wilder.
struct Group {
  std::vector<ViewUser> users;
  std::size_t end = 0;

  std::size_t start() const { return users.front().offset; }
};

std::vector<Group> overlapping(std::vector<ViewUser> users) {
  std::stable_sort(users.begin(), users.end(),
                   [](const ViewUser& a, const ViewUser& b) { return a.offset < b.offset; });
  std::vector<Group> groups;
  for (ViewUser& user : users) {
    if (groups.empty() || user.offset >= groups.back().end) groups.push_back({{}, user.end});
    groups.back().end = std::max(groups.back().end, user.end);
    groups.back().users.push_back(user);
  }
  return groups;
}

std::size_t new_count(const ViewUser& user) { return user.content != nullptr ? user.content->count : user.count; }
std::size_t new_element(const ViewUser& user) {
  return user.content != nullptr ? user.content->format.bytes : user.element;
}

/// Whether the group is rows of one stride with every user at a place of its own in the row, and stays so.
bool is_interleaved(const Group& group) {
  const ViewUser& first = group.users.front();
  std::optional<std::size_t> count;
  std::size_t free_from = first.offset;
  for (const ViewUser& user : group.users) {
    const bool in_row = user.element != 0 && user.stride == first.stride && user.count == first.count &&
                        user.offset - first.offset + user.element <= first.stride;
    if (!in_row || user.raw != nullptr || user.offset < free_from) return false;
    free_from = user.offset + user.element;
    if (user.released) continue;
    if (count && *count != new_count(user)) return false;
    count = new_count(user);
  }
  return count.has_value();
}

Block raw_block(const std::vector<ViewUser>& users, Bytes bytes, std::size_t stride) {
  Block block;
  std::size_t start = bytes.size(), end = 0;
  for (const ViewUser& user : users) {
    start = std::min(start, user.offset);
    end = std::max(end, user.end);
  }
  block.bytes.assign(bytes.begin() + static_cast<std::ptrdiff_t>(start),
                     bytes.begin() + static_cast<std::ptrdiff_t>(end));
  for (const ViewUser& user : users) block.places.push_back({user.holder, user.offset - start});
  block.stride = stride;
  block.row = users.front().stride;
  return block;
}

/// Rows written anew, at the old places in the row where these still hold, else packed.
std::optional<Block> interleaved_block(const Group& group, Bytes bytes, std::size_t view_stride) {
  std::vector<const ViewUser*> live;
  bool as_before = true;
  const Content* any = nullptr;
  for (const ViewUser& user : group.users) {
    as_before = as_before && !user.released && new_element(user) == user.element;
    if (!user.released) live.push_back(&user);
    if (user.content != nullptr) any = user.content;
  }
  std::vector<std::size_t> places;
  std::size_t row = 0;
  for (const ViewUser* user : live) {
    places.push_back(as_before ? user->offset - group.start() : row);
    row += padded(new_element(*user));
  }
  const bool vertices = any == nullptr || any->kind == Content::Kind::vertices;
  if (as_before) row = group.users.front().stride;
  if (!as_before && live.size() == 1 && !vertices) row = new_element(*live.front());
  if (row > greatest_stride && row != new_element(*live.front())) return std::nullopt;

  const std::size_t count = new_count(*live.front());
  Block block;
  block.bytes.assign(count * row, std::byte{0});
  for (std::size_t m = 0; m < live.size(); ++m) {
    const ViewUser& user = *live[m];
    const std::size_t element = new_element(user);
    const std::byte* from = user.content != nullptr ? user.content->bytes.view().data() : bytes.data() + user.offset;
    const std::size_t step = user.content != nullptr ? element : user.stride;
    copy_rows(block.bytes.data() + places[m], row, from, step, element, count);
    block.places.push_back({user.holder, places[m]});
  }
  const bool must_say = live.size() > 1 || row != new_element(*live.front());
  if (must_say || (vertices && view_stride != 0)) block.stride = row;
  block.row = row;
  block.kind = any == nullptr ? Content::Kind::vertices : any->kind;
  return block;
}

}  // namespace

Block block_of(Holder holder, const Content& content, std::size_t stride) {
  const bool vertices = content.kind == Content::Kind::vertices;
  const std::size_t element = content.format.bytes;
  const std::size_t row = vertices ? padded(element) : element;
  Block block;
  block.bytes.assign(content.count * row, std::byte{0});
  copy_rows(block.bytes.data(), row, content.bytes.view().data(), element, element, content.count);
  block.places.push_back({holder, 0});
  block.stride = vertices && (row != element || stride != 0) ? row : 0;
  block.row = row;
  block.kind = content.kind;
  return block;
}

std::vector<Block> blocks_of(std::vector<ViewUser> users, Bytes bytes, std::size_t stride, bool keep) {
  std::vector<Block> blocks;
  for (const Group& group : overlapping(std::move(users))) {
    const bool changes = std::any_of(group.users.begin(), group.users.end(), [](const auto& u) { return u.changes(); });
    const bool all_change =
        std::all_of(group.users.begin(), group.users.end(), [](const auto& u) { return u.changes(); });
    if (!changes) {
      if (!keep) blocks.push_back(raw_block(group.users, bytes, stride));
      continue;
    }
    if ((all_change || !keep) && is_interleaved(group)) {
      if (auto block = interleaved_block(group, bytes, stride)) {
        blocks.push_back(std::move(*block));
        continue;
      }
    }
    std::vector<ViewUser> unchanged;
    std::vector<std::pair<const Content*, std::size_t>> made;  // several may have shared bytes, and still do
    for (const ViewUser& user : group.users) {
      if (user.content != nullptr) {
        const auto same = std::find_if(made.begin(), made.end(),
                                       [&](const auto& m) { return same_content(*m.first, *user.content); });
        if (same != made.end()) {
          blocks[same->second].places.push_back({user.holder, 0});
        } else {
          made.emplace_back(user.content, blocks.size());
          blocks.push_back(block_of(user.holder, *user.content, stride));
        }
      }
      if (user.raw != nullptr) {
        Block block;
        block.bytes.assign(user.raw->view().begin(), user.raw->view().end());
        block.alone = true;
        block.places.push_back({user.holder, 0});
        blocks.push_back(std::move(block));
      }
      if (!user.changes()) unchanged.push_back(user);
    }
    if (!unchanged.empty() && !keep) blocks.push_back(raw_block(unchanged, bytes, stride));
  }
  return blocks;
}

}  // namespace foredraw::gltf
