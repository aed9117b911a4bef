#pragma once

#include "relievo/render.h"
