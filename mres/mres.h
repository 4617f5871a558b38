// The one include of a user.
#pragma once

#include "mres/effect.h"
#include "mres/frame.h"
#include "mres/multi_resolution.h"
#include "mres/report.h"
#include "mres/settings.h"
