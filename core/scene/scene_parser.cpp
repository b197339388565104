#include "core/scene/scene_parser.h"

#include "core/scene/entries.h"
#include "core/scene/json_reader.h"
#include "core/scene/override.h"
#include "core/scene/scene_builder.h"
#include "core/scene/scene_text.h"
#include "core/scene/table_reader.h"
#include "core/scene/toml_reader.h"

namespace wuerfel {

Scene parse_scene(std::string_view text,
                  const std::string& name,
                  const std::vector<std::string>& overrides,
                  const std::vector<std::string>& origins) {
  const SceneSource source{name, overrides, origins};
  const SceneLanguage language = language_of(text, name);
  check_text(text, language, source);
  Value document =
      language == SceneLanguage::json ? read_json(text, source) : read_toml(text, source);
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    apply_override(document, static_cast<int>(i), source);
  }
  SceneEntries entries;
  TableReader reader(source, document, "");
  describe(reader, entries);
  reader.finish();
  return build_scene(entries, source);
}

}  // namespace wuerfel
