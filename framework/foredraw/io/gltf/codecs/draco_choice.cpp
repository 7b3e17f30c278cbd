// Which primitives are compressed by Draco: those that come back, and make the file shorter.
#include <foredraw/io/gltf/codecs/private/draco_primitives.h>
#include <foredraw/io/gltf/layout/private/layout.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/rows.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace foredraw::gltf {

namespace {

// Of plain to compressed bytes that our reader believes, where a file claims more than so many bytes.
constexpr std::size_t greatest_ratio = 256, most_bytes = std::size_t{64} << 20;

class DracoChoosing {
 public:
  DracoChoosing(Json& json, const LaidOut& laid_out, const DracoOutput& how)
      : json_(json), laid_out_(laid_out), how_(how), rows_(json) {}

  DracoChoice run() {
    find();
    find_who_shares();
    for (DracoTriangles& one : all_) encode(one);
    choose();
    release();
    return std::move(choice_);
  }

 private:
  const Json& primitive(const DracoTriangles& one) const {
    const auto& [mesh, number] = one.primitives.front();
    return json_["meshes"][mesh]["primitives"][number];
  }

  bool is_plain(std::size_t accessor) const { return rows_.group_of(accessor).has_value(); }

  void find() {
    std::map<std::string, std::size_t> number;
    each_primitive(json_, [&](Json& primitive, std::size_t m, std::size_t p) {
      ++choice_.primitives;
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
    for (const DracoTriangles& one : all_) {
      for (const std::size_t a : one.accessors) ours[a] += one.primitives.size();
      std::set<std::size_t> groups;
      for (const std::size_t a : one.accessors) groups.insert(*rows_.group_of(a));
      for (const std::size_t group : groups) ++users[group];
    }
    held_.assign(rows_.count(), false);
    for (std::size_t a = 0; a < named.size(); ++a) {
      if (is_plain(a) && (named[a] > ours[a] || how_.held.contains(a))) held_[*rows_.group_of(a)] = true;
    }
    for (DracoTriangles& one : all_) {
      for (const std::size_t a : one.accessors) {
        const std::size_t group = *rows_.group_of(a);
        if (held_[group] || users[group] > 1) one.is_alone = false;
      }
      for (const auto& [mesh, number] : one.primitives)
        one.is_alone = one.is_alone && !json_["meshes"][mesh]["primitives"][number].contains("targets");
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

  void encode(DracoTriangles& one) {
    const Json& attributes = primitive(one)["attributes"];
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
    one.coded = draco_encoded(input, how_.edgebreaker && !how_.holds_products && one.is_alone);
    if (!one.coded) return;
    if (one.coded->keeps_order) one.coded->decoded = {};
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
    for (const DracoTriangles& one : all_) {
      for (const std::size_t a : one.accessors)
        part[root(*rows_.group_of(a))] = root(*rows_.group_of(one.accessors[0]));
    }
    for (const DracoTriangles& one : all_) {
      for (const std::size_t a : accessors_left_out(one)) held_[*rows_.group_of(a)] = true;
    }
    std::vector<std::int64_t> gain(part.size(), 0);
    std::vector<bool> is_whole(part.size(), true);
    std::set<std::size_t> counted;
    for (const DracoTriangles& one : all_) {
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
    for (DracoTriangles& one : all_) {
      const std::size_t of = root(*rows_.group_of(one.accessors[0]));
      if (is_whole[of] && gain[of] > 0) choice_.triangles.push_back(std::move(one));
    }
  }

  std::vector<std::size_t> accessors_left_out(const DracoTriangles& one) const {
    std::vector<std::size_t> left;
    for (std::size_t i = 0; one.coded && i < one.coded->ids.size(); ++i) {
      if (!one.coded->ids[i]) left.push_back(one.accessors[i]);
    }
    return left;
  }

  /// Accessors that Draco's buffers stand for lose their bytes, unless somebody else needs these.
  void release() {
    for (const DracoTriangles& one : choice_.triangles) {
      for (const std::size_t a : one.accessors) {
        if (!held_[*rows_.group_of(a)]) choice_.released.insert(a);
      }
    }
  }

  Json& json_;
  const LaidOut& laid_out_;
  const DracoOutput& how_;
  const SharedRows rows_;
  std::vector<DracoTriangles> all_;
  std::vector<bool> held_;   ///< [group] somebody else needs the rows
  std::size_t claimed_ = 0;  ///< bytes that come out of all
  DracoChoice choice_;
};

}  // namespace

DracoChoice chosen_primitives(Json& json, const LaidOut& laid_out, const DracoOutput& how) {
  return DracoChoosing(json, laid_out, how).run();
}

}  // namespace foredraw::gltf
