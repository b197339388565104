#include "app/sweep/sweep_file.h"

#include <array>
#include <cmath>

#include "app/sweep/sweep_entries.h"
#include "app/sweep/sweep_reader.h"
#include "core/scene/table_reader.h"

namespace wuerfel {

namespace {

/// Quotas in the proportions there are, together so many cases.
void share_out(long cases, BalanceEntry& balance) {
  const std::array quotas{&balance.stands, &balance.falls, &balance.moves};
  long before = 0;
  for (const auto* quota : quotas)
    before += quota->value_or(0);
  for (auto* quota : quotas) {
    if (!*quota) continue;
    const double share = static_cast<double>(**quota) / static_cast<double>(before);
    before -= **quota;
    *quota = std::lround(share * static_cast<double>(cases));
    cases -= **quota;
  }
}

}  // namespace

Sweep parse_sweep(const SceneText& sweep,
                  const std::optional<SceneText>& scene,
                  std::optional<long> cases) {
  const SceneSource source{sweep.name, {}};
  const Value document = read_document(sweep.text, source);
  SweepEntries entries;
  TableReader reader(source, document, "");
  describe(reader, entries);
  reader.finish();
  const bool balanced = entries.balance.stands || entries.balance.falls || entries.balance.moves;
  if (cases && balanced) share_out(*cases, entries.balance);
  if (cases) entries.cases = cases;
  return read_sweep(entries, source, scene);
}

std::vector<std::string> overrides_of(const Sweep& sweep, const std::vector<std::string>& values) {
  std::vector<std::string> overrides;
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (const std::string& key : sweep.variables[v].keys)
      overrides.push_back(key + "=" + values[v]);
  }
  return overrides;
}

}  // namespace wuerfel
