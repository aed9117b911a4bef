#pragma once

#include "relievo/run_context.h"
