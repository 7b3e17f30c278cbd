#include <foredraw/pipeline/output_words.h>

#include <foredraw/pipeline/private/line_scanner.h>
#include <foredraw/pipeline/private/set_word.h>

namespace foredraw {

OptionTable<OutputSettings> output_words() {
  OptionTable<OutputSettings> table;
  table.choice(
      &OutputSettings::compression, "compression",
      "keep: what was read compressed is written compressed; none: nothing is; ext-meshopt: all is, by "
      "EXT_meshopt_compression, which most readers know; khr-meshopt: by KHR_meshopt_compression, which is shorter and "
      "newer; draco: by KHR_draco_mesh_compression, in the order that there is; draco-edgebreaker: by the same, which "
      "undoes all orders",
      {{"keep", Compression::keep},
       {"none", Compression::none},
       {"ext-meshopt", Compression::ext},
       {"khr-meshopt", Compression::khr},
       {"draco", Compression::draco},
       {"draco-edgebreaker", Compression::draco_edgebreaker}});
  table.choice(&OutputSettings::turns_corners, "corners",
               "What compression may do to the corners of triangles: keep: nothing; turn: a triangle may start at "
               "another of its corners, which takes less than half of the bytes of indices and shows the same picture",
               {{"keep", false}, {"turn", true}});
  table.choice(&OutputSettings::levels, "levels",
               "How to write levels of detail that a stage made: keep, as FOREDRAW_levels; msft-lod, as nodes with "
               "MSFT_lod",
               {{"keep", LevelsAs::extension}, {"msft-lod", LevelsAs::lod_nodes}});
  table.choice(&OutputSettings::has_products, "products",
               "keep: what stages made besides triangles and vertices is written with the scene, as optional "
               "extensions; none: it is left out",
               {{"keep", true}, {"none", false}});
  return table;
}

Settings words_of(const OutputSettings& output) {
  const OptionTable<OutputSettings> table = output_words();
  Settings words;
  for (const OptionSpec& spec : table.specs()) {
    for (const std::string& word : spec.choices) {
      OutputSettings with_word = output;
      table.apply({{spec.name, word}}, with_word);
      if (with_word == output && spec.default_value != OptionValue(word)) words[spec.name] = word;
    }
  }
  return words;
}

bool set_output(OutputSettings& output, const std::string& word, const OptionValue& value, const Where& where,
                Diagnostics& diagnostics) {
  return set_word(output_words(), output, {word, value, where, where}, diagnostics);
}

bool set_output(OutputSettings& output, std::string_view line, const std::string& name, Diagnostics& diagnostics) {
  const auto words = scan_options(line, {Where{name, 1, 1, {}}}, diagnostics);
  bool good = words.has_value();
  for (const auto& [word, value] : words ? words->values : Settings()) {
    good = set_output(output, word, value, words->where.at(word), diagnostics) && good;
  }
  return good;
}

}  // namespace foredraw
