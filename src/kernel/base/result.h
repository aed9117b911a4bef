#pragma once

#include "relievo/result.h"
