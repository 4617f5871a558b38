// Compiles what users include as they compile it: without the include path of the shaders' parameter headers,
// whose macros have no prefix.
#include "effects/soft_shadows/soft_shadows.h"
#include "effects/ssao/ssao.h"
#include "effects/ssgi/ssgi.h"
#include "mres/mres.h"

#if defined(UNIFORM_BLOCK) || defined(BEGIN_PARAMS) || defined(SSAO_MAX_SAMPLES) || defined(SSGI_BLOCK_POINTS)
#error "A public header includes a header of the shaders."
#endif
