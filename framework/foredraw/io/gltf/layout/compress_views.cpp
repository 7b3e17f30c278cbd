// Buffer views that are laid out plain, compressed for one of the meshopt extensions.
#include <foredraw/io/gltf/layout/private/layout.h>

#include <algorithm>
#include <set>
#include <utility>

namespace foredraw::gltf {

namespace {

using Mode = Coding::Mode;
using Filter = Coding::Filter;

/// How the accessors of a view use it.
struct Use {
  std::size_t element = 0;  ///< bytes; 0: they differ
  bool indices = false;
  bool triangles = false;  ///< of lists of triangles alone
  bool other = false;      ///< images and others need the bytes themselves
};

class Compressing {
 public:
  Compressing(Json& json, LaidOut& laid_out, const std::string& extension, bool turns_corners)
      : json_(json),
        laid_out_(laid_out),
        extension_(extension),
        other_(extension == khr_meshopt ? ext_meshopt : khr_meshopt),
        version_(extension == khr_meshopt ? meshopt::VertexVersion::v1 : meshopt::VertexVersion::v0),
        turns_corners_(turns_corners) {}

  void run() {
    if (!json_.contains("bufferViews")) return;
    was_ = std::exchange(laid_out_.bytes, {});
    const std::vector<Use> uses = uses_of_views();
    for (std::size_t v = 0; v < uses.size(); ++v) {
      Json& view = json_["bufferViews"][v];
      const bool is_coded = put_stream(view, other_) || put_stream(view, extension_);
      if (view["buffer"] != 0 || (!is_coded && compress(view, uses[v]))) continue;
      const Bytes plain = bytes_of(view);
      set_place(view, 0, append(plain, 8), plain.size());
    }
    laid_out_.bytes.resize(aligned(laid_out_.bytes.size(), 4));
    for (Fallback& fallback : laid_out_.fallbacks) {
      Json said = take_extension(fallback.json, other_);
      if (!said.is_null()) fallback.json["extensions"][extension_] = std::move(said);
    }
    if (made_ != 0) {
      laid_out_.fallbacks.push_back(
          {JsonObject{{"extensions", JsonObject{{extension_, JsonObject{{"fallback", true}}}}}}, made_, false, {}});
    }
    list();
  }

 private:
  Bytes bytes_of(const Json& range) const {
    return Bytes(was_).subspan(range.value("byteOffset", std::size_t{0}), range["byteLength"].get<std::size_t>());
  }

  std::size_t append(Bytes bytes, std::size_t alignment) {
    std::vector<std::byte>& to = laid_out_.bytes;
    to.resize(aligned(to.size(), alignment));
    const std::size_t at = to.size();
    to.insert(to.end(), bytes.begin(), bytes.end());
    return at;
  }

  std::vector<Use> uses_of_views() const {
    std::set<std::size_t> indices, others;  // accessors; `others` of strips, fans, lines and points
    each_primitive(json_, [&](const Json& primitive) {
      if (!primitive.contains("indices")) return;
      indices.insert(primitive["indices"].get<std::size_t>());
      if (primitive.value("mode", 4) != 4) others.insert(primitive["indices"].get<std::size_t>());
    });
    std::vector<Use> uses(json_["bufferViews"].size(), {0, false, false, true});
    const auto use = [&](const Json& holder) -> Use& { return uses[holder["bufferView"].get<std::size_t>()]; };
    std::set<std::size_t> seen;
    for (std::size_t a = 0; json_.contains("accessors") && a < json_["accessors"].size(); ++a) {
      const Json& accessor = json_["accessors"][a];
      if (!accessor.contains("bufferView")) continue;
      const auto format =
          format_of(accessor["type"].get<std::string>(), accessor["componentType"].get<std::uint64_t>(), false);
      Use& one = use(accessor);
      const bool is_list = indices.contains(a) && !others.contains(a) &&
                           accessor["count"].get<std::size_t>() % 3 == 0 &&
                           accessor.value("byteOffset", std::size_t{0}) % (3 * (format ? format->bytes : 1)) == 0;
      const Use now{format ? format->bytes : 0u, indices.contains(a), is_list, !format};
      const bool first = seen.insert(accessor["bufferView"].get<std::size_t>()).second;
      one = first ? now
                  : Use{one.element == now.element ? one.element : 0, one.indices, one.triangles && now.triangles,
                        one.other || now.other || one.indices != now.indices};
    }
    for (const Json& accessor : json_.value("accessors", Json::array())) {
      if (!accessor.contains("sparse")) continue;
      for (const char* part : {"indices", "values"}) use(accessor["sparse"][part]).other = true;
    }
    for (const Json& image : json_.value("images", Json::array())) {
      if (image.contains("bufferView")) use(image).other = true;
    }
    return uses;
  }

  /// The elements that a view is compressed as; 0 where it can not be.
  static std::size_t stride_of(const Json& view, const Use& use) {
    const auto length = view["byteLength"].get<std::size_t>();
    const std::size_t told = view.value("byteStride", use.element);
    if (use.indices) return length % std::max<std::size_t>(told, 1) == 0 && (told == 2 || told == 4) ? told : 0;
    if (told != 0 && told % 4 == 0 && told <= 256 && length % told == 0) return told;
    return length % 4 == 0 && !view.contains("byteStride") ? 4 : 0;
  }

  /// False where that is not possible, or not shorter.
  bool compress(Json& view, const Use& use) {
    const std::size_t stride = use.other ? 0 : stride_of(view, use);
    if (stride == 0) return false;
    const Bytes plain = bytes_of(view);
    const Mode list = use.triangles && turns_corners_ ? Mode::triangles : Mode::indices;
    const Coding coding{use.indices ? list : Mode::attributes, Filter::none, 0, 0, version_};
    const auto stream = compressed(plain, stride, coding, {});
    if (!stream || stream->bytes.size() >= plain.size()) return false;
    Json& extension = view["extensions"][extension_];
    set_place(extension, 0, append(stream->bytes, 4), stream->bytes.size());
    extension["byteStride"] = stride;
    extension["count"] = stream->coding.count;
    extension["mode"] = name_of(stream->coding.mode);
    if (stream->coding.filter != Filter::none) extension["filter"] = name_of(stream->coding.filter);
    set_place(view, 1 + laid_out_.fallbacks.size(), made_, plain.size());
    made_ += aligned(plain.size(), 8);
    return true;
  }

  /// A view's stream, for the extension that is asked for. False where the view has none of extension `from`.
  bool put_stream(Json& view, const std::string& from) {
    if (extension_of(view, from) == nullptr) return false;
    Json stream = take_extension(view, from);
    Bytes bytes = bytes_of(stream);
    std::vector<std::byte> made;
    const bool moves = from == extension_ || recode(stream, bytes, made);
    if (!made.empty()) bytes = made;
    set_place(stream, 0, append(bytes, 4), bytes.size());
    view["extensions"][moves ? extension_ : from] = std::move(stream);
    return true;
  }

  /// The stream in the version that is asked for; `made` stays empty where it is that already. Filter COLOR is KHR's
  /// alone. False where the stream is of a kind that nobody here knows.
  bool recode(Json& json, Bytes stream, std::vector<std::byte>& made) const {
    Coding coding{mode_of(json["mode"].get<std::string>()), filter_of(json.value("filter", "NONE")),
                  json["count"].get<std::size_t>(), json["byteStride"].get<std::size_t>()};
    if (coding.mode == Mode::unknown || coding.filter == Filter::unknown) return false;
    if (!unknown_codec(coding.mode, stream).empty()) return false;
    const bool color = coding.filter == Filter::color && extension_ == ext_meshopt;
    if (coding.mode != Mode::attributes || (meshopt::vertex_version(stream) == version_ && !color)) return true;
    auto elements = unfiltered(coding, stream);
    if (!elements) return false;
    if (color) {
      apply_filter(coding, *elements);
      json["filter"] = name_of(Filter::none);
    }
    made = meshopt::encode_vertices(*elements, coding.stride, version_);
    return true;
  }

  void list() {
    const auto in_it = [&](const Json& view) { return extension_of(view, extension_) != nullptr; };
    if (std::ranges::none_of(json_["bufferViews"], in_it)) return;
    list_extension(json_, "extensionsUsed", extension_);
    const bool needed = std::ranges::any_of(laid_out_.fallbacks, [](const Fallback& one) { return !one.there; });
    if (needed) list_extension(json_, "extensionsRequired", extension_);
  }

  Json& json_;
  LaidOut& laid_out_;
  const std::string extension_;
  const std::string other_;
  const meshopt::VertexVersion version_;
  const bool turns_corners_;
  std::vector<std::byte> was_;  ///< buffer 0, before
  std::size_t made_ = 0;        ///< bytes of the fallback for views that are compressed here
};

}  // namespace

void compress_views(Json& json, LaidOut& laid_out, const std::string& extension, bool turns_corners) {
  Compressing(json, laid_out, extension, turns_corners).run();
}

}  // namespace foredraw::gltf
