#pragma once

#include "relievo/point.h"
