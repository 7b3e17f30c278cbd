#pragma once
// The check of a glTF file's raw bytes, before any reader relies on them. Everything that a count, an index or a length
// in the file claims is held against what is there. Private to io.

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/parallel.h>
#include <foredraw/io/gltf/private/document.h>
#include <foredraw/io/reading/faults.h>
#include <foredraw/io/reading/scene_input.h>

#include <limits>
#include <map>
#include <set>

namespace foredraw::gltf {

/// The document, or nullopt with an error for each kind of mistake (the first twenty). What has one meaning only, or is
/// not used, is mended in the document with a warning for each kind, or refused where `how` is strict.
std::optional<Document> open_document(Shared<std::byte> file, const std::string& name,
                                      const std::filesystem::path& folder, const SceneInput& how,
                                      Diagnostics& diagnostics);

/// What the checks share: the document as far as it was found sound, and where mistakes go.
class Gate {
 public:
  Gate(Document& document, Diagnostics& diagnostics, const SceneInput& how)
      : document_(document), diagnostics_(diagnostics), how_(how), faults_(diagnostics, how.strict) {}

  Document& document() { return document_; }
  const Document& document() const { return document_; }
  const Json& json() const { return document_.json; }
  const SceneInput& how() const { return how_; }
  bool sound() const { return errors_.empty() && not_kept_ == 0; }

  void error(const std::string& place, std::string code, std::string message, std::string hint = {});

  /// The same for memory's sake: it counts where nobody refers to the element, too, unless an extension that only
  /// Foredraw reads is all that names it.
  void too_much(const std::string& place, std::string code, std::string message, std::string hint = {});

  /// One of the kinds of faults.h, which does not keep the file from being read.
  void fault(std::string_view code, const std::string& place, std::string message);

  /// As above, and the member at `place` is left out of the document when all checks are done.
  void leave_out(std::string_view code, const std::string& place, std::string message);

  /// Errors that `check` finds are such a fault of the member at `place`.
  template <class Check>
  void leave_out_if_wrong(std::string_view code, const std::string& place, Check check) {
    const std::size_t before = errors_.size();
    check();
    if (errors_.size() > before) leave_out(code, place, take_errors(before).front().message);
  }

  /// Errors that `check` finds count only where somebody refers to the element; else they are the fault `unused-data`.
  template <class Check>
  auto only_if_used(const char* kind, std::size_t number, Check check) {
    const std::size_t before = errors_.size();
    auto made = check();
    if (errors_.size() > before) hold_back(kind, number, before);
    return made;
  }

  /// The document, to be mended: it will not stay as it came. References to members that are not changed stay valid
  /// where none is added or erased.
  Json& mend();
  Json& mend_at(const std::string& place);

  /// What was held back, and nobody referred to, falls to a fault.
  void let_go_of_unused();
  void warning(const std::string& place, std::string code, std::string message);
  void error_at(std::size_t byte, std::string_view text, std::string code, std::string message, std::string hint = {});
  void note(const std::string& place, std::string code, std::string message);

  /// Tells what was found, and mends the document. False where it is refused.
  bool finish();

  /// The top-level array of that name; an empty one where there is none.
  const Json& all(const char* kind) const;
  std::size_t count(const char* kind) const { return all(kind).size(); }

  /// Members of `parent`, which lies at `place`. Absent ones give nothing; wrong ones an error and nothing.
  const Json* array(const Json& parent, const char* key, const std::string& place);
  const Json* object(const Json& parent, const char* key, const std::string& place);
  std::optional<std::string> text(const Json& parent, const char* key, const std::string& place);
  std::optional<bool> boolean(const Json& parent, const char* key, const std::string& place);
  std::optional<std::uint64_t> whole(const Json& parent, const char* key, const std::string& place,
                                     std::uint64_t least = 0,
                                     std::uint64_t most = std::numeric_limits<std::int64_t>::max());
  /// An array of numbers that fit 32-bit floats; `size` 0: any number of them.
  bool numbers(const Json& parent, const char* key, const std::string& place, std::size_t size);
  std::optional<double> number(const Json& parent, const char* key, const std::string& place);

  /// A reference into the top-level array `kind`.
  std::optional<std::size_t> reference(const Json& parent, const char* key, const char* kind, const std::string& place);
  std::optional<std::size_t> reference(const Json& value, const char* kind, const std::string& place);
  /// Those of an array; wrong ones are left out.
  std::vector<std::size_t> references(const Json& parent, const char* key, const char* kind, const std::string& place);
  void required(const Json& parent, const char* key, const std::string& place);

  /// The accessor's layout; nothing where it was found wrong.
  const Accessor* accessor(std::optional<std::size_t> number) const;

  /// The buffer view; nothing where it was found wrong.
  const BufferView* view(std::optional<std::size_t> number) const;

  std::vector<std::optional<Accessor>> accessors;

 private:
  std::vector<Diagnostic> take_errors(std::size_t from);
  void hold_back(const char* kind, std::size_t number, std::size_t from);

  /// Errors that were held back of it count now. False: there are none.
  bool tell_held_back(std::string_view kind, std::size_t number);

  Document& document_;
  Diagnostics& diagnostics_;
  const SceneInput& how_;
  Faults faults_;
  std::vector<Diagnostic> errors_;
  std::size_t not_kept_ = 0;  ///< errors beyond those
  std::vector<Diagnostic> warnings_;
  struct HeldBack {
    std::vector<Diagnostic> errors;
    bool is_too_much = false;
  };
  std::map<std::pair<std::string_view, std::size_t>, HeldBack> held_back_;
  bool is_too_much_ = false;           ///< one of the errors that were not held back yet
  std::vector<std::string> left_out_;  ///< places of members
};

/// How many bytes buffer views, or accessors, may claim together: 64 MB, and `times` those that are there. Some overlap
/// is common, as primitives view one stream; but a small file whose parts all lie over one another must not fill the
/// memory.
std::uint64_t most_claimed(const Gate& gate, std::uint64_t times = 16);

std::string at(const std::string& place, std::size_t i);
std::string in(const std::string& place, std::string_view key);

// Each of these looks at one part; they run in this sequence.
struct Container {
  std::string_view json;
  std::optional<Bytes> bin;
};
std::optional<Container> open_container(Gate& gate);
bool parse_json(Gate& gate, std::string_view text);
bool check_structure(Gate& gate);
void check_extensions(Gate& gate);
void check_buffers(Gate& gate, std::optional<Bytes> bin);
void check_views(Gate& gate);
void check_compression(Gate& gate);
/// False, with an error, where what Draco compressed could not be decoded. No other check can then say more.
bool check_draco(Gate& gate, const Executor& executor);
void check_accessors(Gate& gate);
void check_images(Gate& gate);
void check_materials(Gate& gate);
void check_meshes(Gate& gate);
void check_nodes(Gate& gate);
void check_instances(Gate& gate);
void check_skins(Gate& gate);
void check_animations(Gate& gate);
void check_finite(Gate& gate);

}  // namespace foredraw::gltf
