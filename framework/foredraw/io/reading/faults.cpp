#include <foredraw/io/reading/faults.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr FaultKind kinds[] = {
    {"trailing-bytes", "glTF", "A GLB has bytes after the length that its header states.", "They are left out.",
     "Every reader stops at that length."},
    {"chunk-length", "glTF", "A chunk's length is not a multiple of 4.",
     "The next chunk is expected right after it. In the output, chunks have whole words.",
     "The length says where it ends."},
    {"byte-order-mark", "glTF", "The JSON starts with a byte order mark.", "It is left out.",
     "It has no meaning in UTF-8."},
    {"version-number", "glTF", "`asset.version` is a number, not a string.", "It is read as a string.",
     "2.0 and \"2.0\" can mean only one version."},
    {"required-extension", "glTF",
     "The file requires an extension that is not known, and that neither triangles nor an accessor, view, node, skin "
     "or animation have.",
     "Its members are kept as they are.", "It cannot change which triangles are drawn where."},
    {"buffer-length", "glTF", "A buffer states more bytes than there are.", "It is as long as its bytes.",
     "What refers to missing bytes is refused."},
    {"fallback", "glTF", "A buffer has neither a `uri` nor a BIN chunk, and all views of it are compressed by meshopt.",
     "It is marked as a fallback.", "What is compressed comes out of other buffers."},
    {"empty-view", "glTF", "A buffer view has no bytes.", "It gets one byte, the least that glTF allows.",
     "It held nothing, so nothing changes."},
    {"view-length", "glTF", "A buffer view ends after its buffer, which has all bytes that it states.",
     "It ends with its buffer.", "No byte is missing, and what refers to bytes after the buffer is refused."},
    {"unused-data", "glTF", "An accessor or buffer view is wrong, and nothing refers to it.",
     "It keeps its number, without its bytes.", "Nothing can be drawn with it."},
    {"view-target", "glTF", "A buffer view's `target` is neither 34962 nor 34963.", "It is left out.",
     "It is a hint; accessors tell what the bytes are."},
    {"alignment", "glTF", "Elements do not start at a multiple of their component's size.",
     "They are read and kept where they lie.", "Offsets and strides say where they are."},
    {"bounds", "glTF", "`min` or `max` is not a list of 32-bit floats, one for each component.", "It is left out.",
     "No stage reads them; new positions get new ones."},
    {"texture", "glTF", "A material names a texture, or a texture an image or sampler, that is not there.",
     "The reference is left out.", "Triangles do not depend on it."},
    {"image", "glTF", "An image has neither a `uri` nor a `bufferView`, or a data URI that is not well-formed.",
     "It is kept without a picture.", "A stage that needs the picture says so."},
    {"material", "glTF",
     "A material's `alphaMode`, `alphaCutoff`, `doubleSided` or `pbrMetallicRoughness` has a value that glTF does not "
     "know.",
     "It is left out; the default counts.", "Viewers take the default, too."},
    {"camera", "glTF", "A node names a camera that is not there.", "The reference is left out.",
     "The node shows the same without it."},
    {"scene", "glTF", "`scene` names a scene that is not there.",
     "It is left out: what a file without it shows is shown.", "Nothing else says which scene is meant."},
    {"nothing-to-draw", "glTF", "A primitive has too few corners for one triangle, line or point.",
     "It is kept as it is.", "It draws nothing."},
    {"morph-targets", "glTF", "Primitives of a mesh have different numbers of morph targets.",
     "They are kept as they are.", "Each is moved by the weights of its own."},
    {"restart", "glTF",
     "Indices of a strip, loop or fan hold the greatest number of their type, and there is no such vertex.",
     "A new strip begins after it.", "Every graphics API of today begins one there."},
    {"restart-index", "glTF",
     "Indices of a list of triangles, lines or points hold the greatest number of their type, and there is such a "
     "vertex.",
     "They are read as that vertex. Indices that are written anew are wider.",
     "glTF forbids restarts, so the vertex is the only meaning left."},
    {"quaternion", "glTF", "A node's rotation is not a unit quaternion.", "It is kept as it is.",
     "Viewers use the four numbers in the same way."},
    {"joint-twice", "glTF", "A skin names a node twice.", "It is kept as it is.", "Each entry is a joint of its own."},
    {"unused-joint", "glTF", "Vertices name joints that the skin does not have, with a weight of zero.",
     "They are kept as they are.", "A weight of zero moves nothing."},
    {"key-times", "glTF", "Key times are equal, fall, or are negative.",
     "The file keeps them. For poses, a time that falls counts as that of the key before.",
     "Poses decide only how triangles are ordered."},
    {"interpolation", "glTF", "An animation's `interpolation` is not one that glTF knows.",
     "It is left out: keys are interpolated linearly.", "Viewers do the same."},
    {"NAME-left-out", "glTF by Foredraw",
     "An extension that only Foredraw reads (`FOREDRAW_levels`, `FOREDRAW_geomorph` ...) is damaged, or does not fit "
     "what the file shows. NAME is what it holds, such as `levels`.",
     "It is left out, with the data that only it names. The others stay.", "The file shows the same without it."},
    {"header-line", "PLY", "A line of the header begins with a word that PLY does not know.", "It is skipped.",
     "The other lines account for every value that follows."},
    {"property-twice", "PLY", "An element has two properties of one name, which Foredraw does not read.",
     "They are kept as they are.", "No triangle depends on them."},
    {"line-values", "PLY",
     "A line of an ASCII file holds more values than its record has, or lacks some that Foredraw does not read.",
     "What is too many is left out.", "The file has just as many lines as records, so each record begins a line."},
    {"bytes-left-out", "PLY, STL", "A binary file continues after its last record.", "The rest is left out.",
     "The header says how many records there are."},
    {"lines-left-out", "PLY, OFF", "A text continues after its last record.", "The rest is left out.",
     "The header says how many records there are."},
    {"not-finite", "OBJ, PLY, OFF", "A number of a normal, texture coordinate or colour is not finite.",
     "It is read as 0.", "Triangles do not depend on it."},
    {"missing-attribute", "OBJ", "Faces name texture coordinates or normals that are not there.",
     "The faces have none.", "Triangles do not depend on them."},
    {"zero-bytes", "OBJ", "Zero bytes follow the text.", "They are skipped.", "Text has no zero bytes."},
    {"elements-left-out", "OBJ", "There are lines, points, curves or surfaces beside the faces.",
     "They are left out. An OBJ keeps them.", "Triangles do not depend on them."},
    {"unknown-line", "OBJ", "A line begins with a word that OBJ does not know.", "It is skipped.",
     "No other line depends on it."},
    {"missing-file", "OBJ", "A material library, or a texture that one names, is not there or must not be opened.",
     "It is left out.", "Triangles do not depend on it."},
    {"unknown-material", "OBJ", "Faces name a material that is in no library.", "Its name is kept.",
     "Triangles do not depend on it."},
    {"keyword", "OFF", "No space separates the keyword from the number of vertices (`OFF8`).",
     "They are read as two words.", "No keyword ends in a digit."},
};

}  // namespace

std::span<const FaultKind> fault_kinds() { return kinds; }

const FaultKind& fault_kind(std::string_view code) { return *std::ranges::find(kinds, code, &FaultKind::code); }

void Faults::found(std::string_view code, Where where, std::string message) {
  if (found_again(code)) return;
  const FaultKind& kind = fault_kind(code);
  first_[kind.code] = {strict_ ? Severity::error : Severity::warning, std::move(where), std::string(code),
                       std::move(message),
                       strict_ ? "without --strict: " + std::string(kind.done) : std::string(kind.done)};
}

bool Faults::found_again(std::string_view code) {
  const auto first = first_.find(code);
  if (first == first_.end()) return false;
  ++first->second.places;
  return true;
}

bool Faults::tell() {
  for (const auto& [code, diagnostic] : first_) diagnostics_.add(diagnostic);
  return !strict_ || first_.empty();
}

}  // namespace foredraw
