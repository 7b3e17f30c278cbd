// What lies interleaved, or one mesh behind the other, taken apart and put together by kind: what a codec makes short.
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/scene/coded_values.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <tuple>

namespace foredraw::gltf {

namespace {

enum class Kind { vertices, triangles, indices, other };

/// Rows of one accessor, or of several that share them.
struct GatheredRows {
  std::size_t view = 0, phase = 0, stride = 0;  ///< of the view; `phase`: where in each stride they begin
  std::size_t element = 0;                      ///< bytes
  Kind kind = Kind::other;
  std::size_t first = 0, end = 0;  ///< numbers of rows in the view
  std::vector<std::size_t> accessors;
};

/// Views that nobody but accessors of whole elements refers to, and that are plain.
std::vector<bool> free_views(const Json& json) {
  std::vector<bool> is_free(json["bufferViews"].size());
  for (std::size_t v = 0; v < is_free.size(); ++v) {
    const Json& view = json["bufferViews"][v];
    is_free[v] = view["buffer"] == 0 && !view.contains("extensions");
  }
  const auto hold = [&](const Json& holder) { is_free[holder["bufferView"].get<std::size_t>()] = false; };
  for (const Json& accessor : json["accessors"]) {
    if (accessor.contains("sparse")) {
      for (const char* part : {"indices", "values"}) hold(accessor["sparse"][part]);
    }
    if (accessor.contains("bufferView") &&
        !format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false)) {
      hold(accessor);
    }
  }
  for (const Json& image : json.value("images", Json::array())) {
    if (image.contains("bufferView")) hold(image);
  }
  return is_free;
}

class Gathering {
 public:
  Gathering(Json& json, LaidOut& laid_out) : json_(json), laid_out_(laid_out) {}

  void run() {
    if (!json_.contains("bufferViews") || !json_.contains("accessors")) return;
    is_free_ = free_views(json_);
    find_kinds();
    const std::vector<GatheredRows> all = rows();
    std::map<Key, std::vector<const GatheredRows*>> groups;
    for (const GatheredRows& one : all) groups[key_of(one)].push_back(&one);
    keep_the_others();
    for (const auto& [key, members] : groups) put(key, members);
    json_["bufferViews"] = std::move(views_);
    for (const Place& place : places_) {
      Json& accessor = json_["accessors"][place.accessor];
      accessor["bufferView"] = place.view;
      accessor.erase("byteOffset");
      if (place.offset > 0) accessor["byteOffset"] = place.offset;
    }
  }

 private:
  /// Where an accessor's rows go. It says where they were until all are read.
  struct Place {
    std::size_t accessor = 0, view = 0, offset = 0;
  };

  /// What lies side by side: the same kind, element and name, and the same lattice where they are floats.
  using Key = std::tuple<Kind, std::size_t, std::string, int>;

  void find_kinds() {
    kinds_.assign(json_["accessors"].size(), Kind::other);
    names_.resize(kinds_.size());
    const auto vertices = [&](const Json& attributes) {
      for (const auto& [name, number] : attributes.items()) {
        kinds_[number.get<std::size_t>()] = Kind::vertices;
        names_[number.get<std::size_t>()] = name;
      }
    };
    std::set<std::size_t> not_lists;
    each_primitive(json_, [&](const Json& primitive) {
      vertices(primitive["attributes"]);
      for (const Json& target : primitive.value("targets", Json::array())) vertices(target);
      if (!primitive.contains("indices")) return;
      const auto number = primitive["indices"].get<std::size_t>();
      kinds_[number] = Kind::triangles;
      if (primitive.value("mode", 4) != 4) not_lists.insert(number);
    });
    for (const std::size_t number : not_lists) kinds_[number] = Kind::indices;
  }

  std::vector<GatheredRows> rows() const {
    std::map<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, Kind>, std::vector<GatheredRows>> found;
    for (std::size_t a = 0; a < json_["accessors"].size(); ++a) {
      const Json& accessor = json_["accessors"][a];
      if (!accessor.contains("bufferView") || !is_free_[accessor["bufferView"].get<std::size_t>()]) continue;
      const auto view = accessor["bufferView"].get<std::size_t>();
      // What extensions alone name may be attributes: those of a view that says how far apart its rows are.
      const bool has_stride = json_["bufferViews"][view].contains("byteStride");
      const Kind kind = kinds_[a] == Kind::other && has_stride ? Kind::vertices : kinds_[a];
      const std::size_t element =
          format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false)->bytes;
      const std::size_t stride = json_["bufferViews"][view].value("byteStride", element);
      const auto offset = accessor.value("byteOffset", std::size_t{0});
      const std::size_t first = offset / stride;
      found[{view, offset % stride, stride, element, kind}].push_back(
          {view, offset % stride, stride, element, kind, first, first + accessor["count"].get<std::size_t>(), {a}});
    }
    std::vector<GatheredRows> all;
    for (auto& [where, several] : found) {
      std::ranges::stable_sort(several, {}, &GatheredRows::first);
      const std::size_t begin = all.size();
      for (GatheredRows& one : several) {  // accessors of rows that overlap stay so
        if (all.size() > begin && one.first < all.back().end) {
          all.back().end = std::max(all.back().end, one.end);
          all.back().accessors.push_back(one.accessors.front());
        } else {
          all.push_back(std::move(one));
        }
      }
    }
    std::ranges::sort(
        all, [](const GatheredRows& a, const GatheredRows& b) { return a.accessors.front() < b.accessors.front(); });
    return all;
  }

  const std::byte* first_row(const GatheredRows& of) const {
    const Json& view = json_["bufferViews"][of.view];
    return laid_out_.bytes.data() + view.value("byteOffset", std::size_t{0}) + of.first * of.stride + of.phase;
  }

  Key key_of(const GatheredRows& rows) const {
    const std::size_t accessor = rows.accessors.front();
    int lattice = 0;
    if (json_["accessors"][accessor]["componentType"] == 5126 && rows.kind == Kind::vertices) {
      lattice = 128;  // of zeros alone
      const std::byte* const begin = first_row(rows);
      for (std::size_t i = rows.first; i < rows.end; ++i) {
        for (std::size_t at = 0; at < rows.element; at += 4) {
          float value = 0;
          std::memcpy(&value, begin + (i - rows.first) * rows.stride + at, 4);
          lattice = std::min(lattice, lattice_of(value).value_or(128));
        }
      }
    }
    return {rows.kind, rows.element, names_[accessor], lattice};
  }

  /// Views that are not taken apart, but for those that have no user left.
  void keep_the_others() {
    std::vector<std::size_t> number(is_free_.size());
    for (std::size_t v = 0; v < is_free_.size(); ++v) {
      if (is_free_[v]) continue;
      number[v] = views_.size();
      views_.push_back(json_["bufferViews"][v]);
    }
    const auto renumber = [&](Json& holder) {
      if (!holder.contains("bufferView")) return;
      const auto v = holder["bufferView"].get<std::size_t>();
      if (!is_free_[v]) holder["bufferView"] = number[v];
    };
    for (Json& accessor : json_["accessors"]) {
      renumber(accessor);
      if (!accessor.contains("sparse")) continue;
      for (const char* part : {"indices", "values"}) renumber(accessor["sparse"][part]);
    }
    if (json_.contains("images")) {
      for (Json& image : json_["images"]) renumber(image);
    }
  }

  /// One view for all of them.
  void put(const Key& key, const std::vector<const GatheredRows*>& members) {
    const Kind kind = std::get<Kind>(key);
    const std::size_t element = std::get<1>(key);
    const std::size_t stride = kind == Kind::vertices ? aligned(element, 4) : element;
    std::vector<std::byte> bytes;
    for (const GatheredRows* rows : members) {
      const std::size_t start = bytes.size();
      bytes.resize(start + (rows->end - rows->first) * stride);
      copy_rows(bytes.data() + start, stride, first_row(*rows), rows->stride, element, rows->end - rows->first);
      for (const std::size_t a : rows->accessors) {
        const auto offset = json_["accessors"][a].value("byteOffset", std::size_t{0});
        places_.push_back({a, views_.size(), start + (offset / rows->stride - rows->first) * stride});
      }
    }
    laid_out_.bytes.resize(aligned(laid_out_.bytes.size(), 8));
    Json view = JsonObject{{"buffer", 0}, {"byteOffset", laid_out_.bytes.size()}, {"byteLength", bytes.size()}};
    if (kind == Kind::vertices) view["byteStride"] = stride;
    if (kind != Kind::other) view["target"] = kind == Kind::vertices ? 34962 : 34963;
    laid_out_.bytes.insert(laid_out_.bytes.end(), bytes.begin(), bytes.end());
    views_.push_back(std::move(view));
  }

  Json& json_;
  LaidOut& laid_out_;
  std::vector<bool> is_free_;
  std::vector<Kind> kinds_;
  std::vector<std::string> names_;
  Json views_ = Json::array();
  std::vector<Place> places_;
};

}  // namespace

void gather_views(Json& json, LaidOut& laid_out) { Gathering(json, laid_out).run(); }

}  // namespace foredraw::gltf
