#pragma once

#include "relievo/model.h"
