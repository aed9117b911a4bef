#pragma once

#include "relievo/bytes.h"
