#pragma once

#include "relievo/maps.h"
