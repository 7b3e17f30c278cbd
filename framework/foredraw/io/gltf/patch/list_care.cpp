#include <foredraw/io/gltf/patch/private/list_care.h>

#include <foredraw/base/counted.h>
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/products.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::gltf {

namespace {

constexpr std::size_t left_out = ~std::size_t{0};

/// " (\"Old\", \"Unused\" and 3 more)"; empty where none has a name.
std::string names_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  if (names.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    text += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", names[i]);
  }
  if (names.size() > most) text += fmt::format(" and {} more", counted(names.size() - most));
  return " (" + text + ')';
}

std::string name_in(const Json& entry) {
  const auto name = entry.find("name");
  return name != entry.end() && name->is_string() ? name->get<std::string>() : std::string();
}

class ListCaring {
 public:
  ListCaring(const Scene& scene, const Document& document, Json& json, AccessorStore& store, Diagnostics& diagnostics)
      : scene_(scene), document_(document), json_(json), store_(store), diagnostics_(diagnostics) {}

  void run() {
    const ListCare& care = scene_.lists;
    if (!care.joins_equal && !care.leaves_out_unnamed) return;
    for (const std::string& extension : extensions_in(json_)) {
      if (names_seen_entries(extension)) continue;
      diagnostics_.note({.file = document_.name, .inside = "extensionsUsed"}, "lists-stay",
                        fmt::format("the extension '{}' may name nodes, materials or images by number; all stay as "
                                    "they are",
                                    extension));
      return;
    }
    const bool is_free = !is_named_outside();
    if (care.joins_equal) {
      for (const char* list : {"samplers", "images", "textures"}) join(list);
      if (is_free) join("materials");
    }
    if (!care.leaves_out_unnamed) return;
    if (is_free) {
      leave_out_unused("skins");
      leave_out_bare_nodes();
      for (const char* list : {"cameras", "materials"}) leave_out_unused(list);
    }
    for (const char* list : {"textures", "samplers", "images"}) leave_out_unused(list);
    if (document_.knows_all_extensions()) shorten_text(json_, care.joins_equal);
    release_accessors();
  }

 private:
  std::size_t count(const char* list) const {
    const auto found = json_.find(list);
    return found != json_.end() && found->is_array() ? found->size() : 0;
  }

  /// Whether products or pointers of animations name entries, too: those of textures, samplers and images never.
  bool is_named_outside() const {
    return std::ranges::any_of(extensions_in(json_), [](const std::string& name) {
      return name.starts_with("FOREDRAW_") || name == "KHR_animation_pointer";
    });
  }

  std::vector<bool> used(const char* list) {
    std::vector<bool> is_used(count(list));
    each_entry_named(json_, [&](const std::string& of, Json& number, Tie tie) {
      if (of == list && tie == Tie::uses) is_used[number.get<std::size_t>()] = true;
    });
    return is_used;
  }

  void note(const std::string& list, const char* code, const std::string& what, std::size_t how_many,
            const std::vector<std::string>& names) {
    diagnostics_.note({.file = document_.name, .inside = list}, code,
                      fmt::format("{}: {}{}", what, counted(how_many), names_of(names)));
  }

  /// [number] = its new number, that of an entry equal to it, or left_out. `target[number]`: which entry it becomes.
  void move(const char* list, const std::vector<std::size_t>& target) {
    std::vector<std::size_t> to(target.size(), left_out);
    Json left = Json::array();
    for (std::size_t i = 0; i < target.size(); ++i) {
      if (target[i] != i) continue;
      to[i] = left.size();
      left.push_back(std::move(json_[list][i]));
    }
    const bool are_images = list == std::string_view("images");
    for (std::size_t i = 0; i < target.size(); ++i) {
      if (target[i] == i) continue;
      if (target[i] != left_out) to[i] = to[target[i]];
      if (are_images && json_[list][i].contains("bufferView")) {
        store_.forget_view(json_[list][i]["bufferView"].get<std::size_t>());
      }
    }
    if (left.empty()) {
      json_.erase(list);
    } else {
      json_[list] = std::move(left);
    }
    each_entry_named(json_, [&](const std::string& of, Json& number, Tie) {
      if (of == list) number = to[number.get<std::size_t>()];
    });
    if (are_images) store_.move_images(to);
  }

  /// What two equal entries have in common.
  std::string key_of(const std::string& list, std::size_t i) const {
    Json entry = json_[list][i];
    if (list != "materials" || !scene_.lists.keeps_names) entry.erase("name");
    if (list != "images") return entry.dump();
    entry.erase("bufferView");
    const Image& image = scene_.images[i];
    return fmt::format("{} {}", entry.dump(), image.bytes.empty() ? "" : to_text(image.bytes.stamp()));
  }

  void join(const char* list) {
    std::map<std::string, std::size_t> first;
    std::vector<std::size_t> target(count(list));
    std::vector<std::string> names;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < target.size(); ++i) {
      target[i] = first.try_emplace(key_of(list, i), i).first->second;
      if (target[i] == i) continue;
      ++joined;
      if (const std::string name = name_in(json_[list][i]); !name.empty()) names.push_back(name);
    }
    if (joined == 0) return;
    note(list, "joined", "equal to others, which stand for them", joined, names);
    move(list, target);
  }

  void leave_out(const char* list, const std::vector<bool>& stays, const std::string& why) {
    std::vector<std::size_t> target(stays.size(), left_out);
    std::vector<std::string> names;
    std::size_t gone = 0;
    for (std::size_t i = 0; i < stays.size(); ++i) {
      if (stays[i]) {
        target[i] = i;
        continue;
      }
      ++gone;
      if (const std::string name = name_in(json_[list][i]); !name.empty()) names.push_back(name);
    }
    if (gone == 0) return;
    note(list, "left-out", "left out, as " + why, gone, names);
    move(list, target);
  }

  void leave_out_unused(const char* list) { leave_out(list, used(list), "nothing names them"); }

  /// A node that shows nothing, holds nothing, moves nothing, and has no name by which an engine may look for it.
  bool is_bare(const Json& node) const {
    return std::ranges::all_of(node.items(), [&](const auto& item) {
      static constexpr std::string_view places[] = {"children", "translation", "rotation", "scale", "matrix"};
      const bool is_place = std::ranges::find(places, item.key()) != std::end(places);
      return is_place || (item.key() == "name" && (!scene_.lists.keeps_names || item.value() == ""));
    });
  }

  void leave_out_bare_nodes() {
    const std::size_t nodes = count("nodes");
    std::vector<bool> stays = used("nodes");
    std::vector<std::size_t> children(nodes), parent(nodes, left_out), open;
    if (nodes > 0 && extension_of(json_, "GODOT_single_root") != nullptr) stays[0] = true;
    for (std::size_t n = 0; n < nodes; ++n) {
      const Json& node = json_["nodes"][n];
      if (!is_bare(node)) stays[n] = true;
      for (const Json& child : node.value("children", Json::array())) {
        parent[child.get<std::size_t>()] = n;
        ++children[n];
      }
      if (!stays[n] && children[n] == 0) open.push_back(n);
    }
    std::vector<bool> is_gone(nodes);
    while (!open.empty()) {
      const std::size_t n = open.back();
      open.pop_back();
      is_gone[n] = true;
      const std::size_t above = parent[n];
      if (above != left_out && --children[above] == 0 && !stays[above]) open.push_back(above);
    }
    is_gone.flip();
    if (std::ranges::find(is_gone, true) == is_gone.end()) return;  // a scene of nothing stays one
    unhold(is_gone);
    leave_out("nodes", is_gone, "they show and move nothing");
  }

  /// Takes out of lists of children and roots what does not stay.
  void unhold(const std::vector<bool>& stays) {
    const auto take = [&](Json& holder, const char* key) {
      const auto found = holder.find(key);
      if (found == holder.end()) return;
      Json left = Json::array();
      for (const Json& number : *found) {
        if (stays[number.get<std::size_t>()]) left.push_back(number);
      }
      if (left.size() == found->size()) return;
      if (left.empty()) {
        holder.erase(key);
      } else {
        *found = std::move(left);
      }
    };
    for (Json& node : json_["nodes"]) take(node, "children");
    if (!json_.contains("scenes")) return;
    for (Json& scene : json_["scenes"]) take(scene, "nodes");
  }

  void release_accessors() {
    if (!document_.knows_all_extensions()) return;
    std::vector<bool> named(document_.accessors.size());
    const auto name = [&](std::size_t number) {
      if (number < named.size()) named[number] = true;
    };
    each_accessor_named(json_, [&](const Json& number) { name(number.get<std::size_t>()); });
    for (const std::size_t number : used_by_products(json_, document_.products)) name(number);
    for (std::size_t a = 0; a < named.size(); ++a) {
      if (!named[a] && !store_.is_new(a)) store_.release(a);
    }
  }

  const Scene& scene_;
  const Document& document_;
  Json& json_;
  AccessorStore& store_;
  Diagnostics& diagnostics_;
};

}  // namespace

void care_for_lists(const Scene& scene, const Document& document, Json& json, AccessorStore& store,
                    Diagnostics& diagnostics) {
  ListCaring(scene, document, json, store, diagnostics).run();
}

}  // namespace foredraw::gltf
