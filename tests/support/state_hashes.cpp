// state_hashes SCENE.toml ..: one number for all states of a second of each scene, by every integrator. Builds by all compilers
// and at all levels print the same: tests/compilers.
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"

int main(int count, char** names) {
  using namespace wuerfel;
  for (int i = 1; i < count; ++i) {
    std::ostringstream text;
    text << std::ifstream(names[i]).rdbuf();
    for (const Integrator integrator :
         {Integrator::automatic, Integrator::event, Integrator::rattle, Integrator::moreau,
          Integrator::euler}) {
      Simulation simulation(parse_scene(text.str(), names[i]), {.integrator = integrator});
      simulation.advance_to(1.0);
      std::printf("%016llx %s %s\n", static_cast<unsigned long long>(simulation.state_hash()),
                  names[i], std::string(to_string(integrator)).c_str());
    }
  }
  return 0;
}
