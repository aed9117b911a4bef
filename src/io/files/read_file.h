#pragma once

#include "relievo/files.h"
