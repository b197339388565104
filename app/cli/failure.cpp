#include "app/cli/failure.h"

#include <new>

#include <fmt/core.h>

#include "app/cli/pace.h"
#include "app/cli/streams.h"
#include "core/scene/scene_parser.h"
#include "render/error.h"

namespace wuerfel {

Failure failure_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const UsageError& error) {
    return {error.what(), ExitCode::bad_input};
  } catch (const SceneError& error) {
    return {error.what(), ExitCode::bad_input};
  } catch (const RenderError& error) {
    return {error.what(), ExitCode::bad_input};
  } catch (const OutputError& error) {  // a library that draws is missing, too
    return {error.what(), ExitCode::output};
  } catch (const EndlessMotion& error) {
    return {error.what(), ExitCode::undecided};
  } catch (const std::bad_alloc&) {
    return {"out of memory", ExitCode::internal};
  } catch (const std::exception& error) {
    return {error.what(), ExitCode::internal};
  }
}

void complain(const std::string& message) { say(fmt::format("wuerfel: {}\n", message)); }

}  // namespace wuerfel
