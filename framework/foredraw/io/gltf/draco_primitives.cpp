// Which primitives are compressed by Draco, and what the document says of them then.
#include <foredraw/io/gltf/private/draco_encode.h>
#include <foredraw/io/gltf/private/draco_primitives.h>
#include <foredraw/io/gltf/private/layout.h>
#include <foredraw/io/gltf/private/rows.h>
#include <foredraw/io/gltf/private/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <utility>

namespace foredraw::gltf {

namespace {

// Of plain to compressed bytes that our reader believes, where a file claims more than so many bytes.
constexpr std::size_t greatest_ratio = 256, most_bytes = std::size_t{64} << 20;

/// Primitives of the same triangles: one buffer is for all of them.
struct Triangles {
  std::vector<std::pair<std::size_t, std::size_t>> primitives;  ///< mesh, and number in it
  std::vector<std::size_t> accessors;                           ///< of attributes by name, and of indices
  bool is_alone = true;                                         ///< nobody else has anything to do with the accessors
  std::optional<DracoCoded> coded;
  std::size_t plain = 0;  ///< bytes that come out of it
  Json extension;
};

class DracoWriting {
 public:
  DracoWriting(Json& json, LaidOut& laid_out, const DracoOutput& how)
      : json_(json), laid_out_(laid_out), how_(how), rows_(json) {}

  void run(const std::string& file, Diagnostics& diagnostics) {
    find();
    if (all_.empty()) return tell(file, diagnostics);
    find_who_shares();
    for (Triangles& one : all_) encode(one);
    choose();
    for (Triangles& one : all_) {
      if (one.coded) put(one);
    }
    release();
    tell(file, diagnostics);
  }

  /// The views, once those that are plain have their numbers.
  void put_views() {
    const std::vector<std::byte> was = std::exchange(laid_out_.bytes, {});
    Json& views = json_["bufferViews"];
    if (views.is_null()) views = Json::array();
    for (Json& view : views) {
      const auto plain = Bytes(was).subspan(view.value("byteOffset", std::size_t{0}), view["byteLength"]);
      set_place(view, 0, append(plain, 8), plain.size());
    }
    for (Triangles& one : all_) {
      if (!one.coded) continue;
      Json view = Json::object();
      set_place(view, 0, append(one.coded->bytes, 4), one.coded->bytes.size());
      for (const auto& place : one.primitives)
        primitive(place)["extensions"][draco_extension]["bufferView"] = views.size();
      views.push_back(std::move(view));
    }
    if (views.empty()) json_.erase("bufferViews");
    laid_out_.bytes.resize(aligned(laid_out_.bytes.size(), 4));
  }

 private:
  std::size_t append(Bytes bytes, std::size_t alignment) {
    std::vector<std::byte>& to = laid_out_.bytes;
    to.resize(aligned(to.size(), alignment));
    const std::size_t at = to.size();
    to.insert(to.end(), bytes.begin(), bytes.end());
    return at;
  }

  /// Looked up each time: a key put into an object moves what it holds.
  Json& primitive(const std::pair<std::size_t, std::size_t>& place) {
    return json_["meshes"][place.first]["primitives"][place.second];
  }

  bool is_plain(std::size_t accessor) const { return rows_.group_of(accessor).has_value(); }

  void find() {
    std::map<std::string, std::size_t> number;
    each_primitive(json_, [&](Json& primitive, std::size_t m, std::size_t p) {
      ++primitives_;
      const bool is_list = primitive.value("mode", 4) == 4 && primitive.contains("indices");
      if (!is_list || !primitive["attributes"].contains("POSITION")) return;
      std::vector<std::size_t> accessors;
      for (const Json& attribute : primitive["attributes"]) accessors.push_back(attribute.get<std::size_t>());
      accessors.push_back(primitive["indices"].get<std::size_t>());
      if (!std::ranges::all_of(accessors, [&](std::size_t a) { return is_plain(a); })) return;
      const std::string key = primitive["attributes"].dump() + primitive["indices"].dump();
      const auto [known, is_new] = number.try_emplace(key, all_.size());
      if (is_new) all_.push_back({.accessors = std::move(accessors)});
      all_[known->second].primitives.emplace_back(m, p);
    });
  }

  void find_who_shares() {
    std::vector<std::size_t> named(json_["accessors"].size(), 0), ours(named.size(), 0);
    each_accessor_named(json_, [&](Json& accessor) { ++named[accessor.get<std::size_t>()]; });
    std::vector<std::size_t> users(rows_.count(), 0);  // sets of triangles
    for (const Triangles& one : all_) {
      for (const std::size_t a : one.accessors) ours[a] += one.primitives.size();
      std::set<std::size_t> groups;
      for (const std::size_t a : one.accessors) groups.insert(*rows_.group_of(a));
      for (const std::size_t group : groups) ++users[group];
    }
    held_.assign(rows_.count(), false);
    for (std::size_t a = 0; a < named.size(); ++a) {
      if (is_plain(a) && (named[a] > ours[a] || how_.held.contains(a))) held_[*rows_.group_of(a)] = true;
    }
    for (Triangles& one : all_) {
      for (const std::size_t a : one.accessors) {
        const std::size_t group = *rows_.group_of(a);
        if (held_[group] || users[group] > 1) one.is_alone = false;
      }
      for (const auto& place : one.primitives) one.is_alone = one.is_alone && !primitive(place).contains("targets");
      const std::set<std::size_t> once(one.accessors.begin(), one.accessors.end());
      one.is_alone = one.is_alone && once.size() == one.accessors.size();
    }
  }

  std::vector<std::byte> elements(std::size_t a, const Format& format) const {
    const Json& accessor = json_["accessors"][a];
    const Json& view = json_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const auto count = accessor["count"].get<std::size_t>();
    const std::size_t first = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    std::vector<std::byte> tight(count * format.bytes);
    copy_rows(tight.data(), format.bytes, laid_out_.bytes.data() + first,
              view.value("byteStride", std::size_t{format.bytes}), format.bytes, count);
    return tight;
  }

  Format format(std::size_t a) const {
    const Json& accessor = json_["accessors"][a];
    return *format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(),
                      accessor.value("normalized", false));
  }

  void encode(Triangles& one) {
    const Json& attributes = primitive(one.primitives.front())["attributes"];
    const std::size_t indices = one.accessors.back();
    const std::vector<std::uint32_t> corners = widened(elements(indices, format(indices)), format(indices).bytes);
    std::vector<std::vector<std::byte>> bytes;
    DracoInput input{json_["accessors"][one.accessors.front()]["count"].get<std::size_t>(), corners, {}};
    for (const auto& [name, number] : attributes.items()) {
      const auto a = number.get<std::size_t>();
      bytes.push_back(elements(a, format(a)));
      input.attributes.push_back({name, format(a), bytes.back()});
    }
    if (corners.empty() || corners.size() % 3 != 0) return;
    one.coded = draco_encoded(input, how_.may_reorder && one.is_alone);
    if (!one.coded) return;
    one.plain = 4 * corners.size();
    for (const auto& attribute : bytes) one.plain += attribute.size();
    claimed_ += one.plain;
    std::size_t at = 0;
    for (const auto& [name, number] : attributes.items()) {
      const auto id = one.coded->ids[at++];
      if (id) one.extension["attributes"][name] = *id;
    }
  }

  /// Those that share rows stay together: compressed where that is shorter.
  void choose() {
    std::vector<std::size_t> part(rows_.count());
    std::iota(part.begin(), part.end(), std::size_t{0});
    const auto root = [&](std::size_t group) {
      while (part[group] != group) group = part[group] = part[part[group]];
      return group;
    };
    for (const Triangles& one : all_) {
      for (const std::size_t a : one.accessors)
        part[root(*rows_.group_of(a))] = root(*rows_.group_of(one.accessors[0]));
    }
    for (const Triangles& one : all_) {
      for (const std::size_t a : accessors_left_out(one)) held_[*rows_.group_of(a)] = true;
    }
    std::vector<std::int64_t> gain(part.size(), 0);
    std::vector<bool> is_whole(part.size(), true);
    std::set<std::size_t> counted;
    for (const Triangles& one : all_) {
      const std::size_t of = root(*rows_.group_of(one.accessors[0]));
      const bool is_too_short = one.coded && one.plain / greatest_ratio > one.coded->bytes.size();
      if (!one.coded || (claimed_ > most_bytes && is_too_short)) {
        is_whole[of] = false;
        continue;
      }
      gain[of] -= static_cast<std::int64_t>(aligned(one.coded->bytes.size(), 4) + one.extension.dump().size());
      for (const std::size_t a : one.accessors) {
        const std::size_t group = *rows_.group_of(a);
        if (!held_[group] && counted.insert(group).second) gain[of] += static_cast<std::int64_t>(rows_.bytes_of(group));
      }
    }
    for (Triangles& one : all_) {
      const std::size_t of = root(*rows_.group_of(one.accessors[0]));
      if (!is_whole[of] || gain[of] <= 0) one.coded.reset();
    }
  }

  std::vector<std::size_t> accessors_left_out(const Triangles& one) const {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; one.coded && i < one.coded->ids.size(); ++i) {
      if (!one.coded->ids[i]) left.push_back(one.accessors[i]);
    }
    return left;
  }

  void put(Triangles& one) {
    for (const auto& place : one.primitives) primitive(place)["extensions"][draco_extension] = one.extension;
    compressed_ += one.primitives.size();
    loose_ += one.coded->loose;
    reordered_ += one.coded->keeps_order ? 0 : one.primitives.size();
    for (const std::size_t a : one.accessors) coded_.insert(a);
    if (one.coded->keeps_order) return;
    // Triangles without area are gone, and vertices that none has or that were there twice.
    const DracoMesh& mesh = one.coded->decoded;
    for (std::size_t i = 0; i < one.coded->ids.size(); ++i) {
      Json& accessor = json_["accessors"][one.accessors[i]];
      accessor["count"] = mesh.points;
      if (accessor.contains("min") || accessor.contains("max")) correct_range(accessor, mesh.attributes[i]);
    }
    Json& indices = json_["accessors"][one.accessors.back()];
    indices["count"] = mesh.indices.size();
    for (const char* key : {"min", "max"}) indices.erase(key);
    if (mesh.points > 0xfffe) indices["componentType"] = 5125;
    if (mesh.points > 0xfe && indices["componentType"] == 5121) indices["componentType"] = 5123;
  }

  static void correct_range(Json& accessor, const std::vector<std::byte>& elements) {
    const auto told =
        *format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false);
    const auto put_of = [&]<class T>(T) {
      std::vector<T> values(elements.size() / sizeof(T)), least, greatest;
      std::memcpy(values.data(), elements.data(), values.size() * sizeof(T));
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t c = i % told.components;
        if (c == least.size()) least.push_back(values[i]), greatest.push_back(values[i]);
        least[c] = std::min(least[c], values[i]);
        greatest[c] = std::max(greatest[c], values[i]);
      }
      if (accessor.contains("min")) accessor["min"] = least;
      if (accessor.contains("max")) accessor["max"] = greatest;
    };
    switch (told.component) {
      case Component::int8: return put_of(std::int8_t{});
      case Component::uint8: return put_of(std::uint8_t{});
      case Component::int16: return put_of(std::int16_t{});
      case Component::uint16: return put_of(std::uint16_t{});
      case Component::uint32: return put_of(std::uint32_t{});
      case Component::float32: return put_of(float{});
    }
  }

  /// Accessors that Draco's buffers stand for lose their bytes, unless somebody else needs these.
  void release() {
    for (const std::size_t a : coded_) {
      if (held_[*rows_.group_of(a)]) continue;
      for (const char* key : {"bufferView", "byteOffset"}) json_["accessors"][a].erase(key);
    }
    if (coded_.empty()) return;
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) list_extension(json_, list, draco_extension);
  }

  void tell(const std::string& file, Diagnostics& diagnostics) const {
    if (compressed_ < primitives_) {
      diagnostics.note({.file = file, .inside = "meshes"}, "draco-left-plain",
                       fmt::format("{} of {} primitives stay plain: Draco knows lists of triangles alone, and makes "
                                   "small meshes and shared vertices longer",
                                   primitives_ - compressed_, primitives_));
    }
    if (loose_ > 0) {
      diagnostics.note({.file = file, .inside = "meshes"}, "draco-keeps-floats",
                       fmt::format("{} attributes of floats are not shorter: no value may be rounded here", loose_),
                       "put `quantize` into the pipeline, which rounds within an error and tells it");
    }
    if (!how_.may_reorder) return;
    diagnostics.warning(
        {.file = file, .inside = "meshes"}, "draco-reorders",
        fmt::format("the edgebreaker method of Draco sorts triangles and vertices: what stages gained by their order "
                    "is gone in {} of {} compressed primitives; what needs its order keeps it",
                    reordered_, compressed_),
        "write it with --compression draco, which keeps all orders");
  }

  Json& json_;
  LaidOut& laid_out_;
  const DracoOutput& how_;
  const SharedRows rows_;
  std::vector<bool> held_;  ///< [group] somebody else needs the rows
  std::vector<Triangles> all_;
  std::set<std::size_t> coded_;  ///< accessors
  std::size_t primitives_ = 0, compressed_ = 0, reordered_ = 0, loose_ = 0;
  std::size_t claimed_ = 0;  ///< bytes that come out of all
};

}  // namespace

void compress_primitives(Json& json, LaidOut& laid_out, const DracoOutput& how, const std::string& file,
                         Diagnostics& diagnostics) {
  DracoWriting writing(json, laid_out, how);
  writing.run(file, diagnostics);
  gather_views(json, laid_out);
  writing.put_views();
}

}  // namespace foredraw::gltf
