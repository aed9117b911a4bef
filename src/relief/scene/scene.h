#pragma once

#include "kernel/geometry/polygon.h"
#include "relievo/scene.h"
