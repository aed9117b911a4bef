#pragma once

#include "relievo/image.h"
