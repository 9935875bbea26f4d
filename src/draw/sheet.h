// A contact sheet: several pictures in a grid, each with a line of text.
#pragma once

#include <string>
#include <vector>

#include "base/workers.h"
#include "draw/theme.h"
#include "sturnus/picture.h"

namespace sturnus {

/// The pictures from left to right and from top to bottom, `columns` in a row. All cells are as large as the
/// largest picture; smaller ones stand in the middle. Captions that are missing or empty leave their line
/// empty; where all are, no room is kept for them.
Image contact_sheet(const std::vector<Image>& pictures, const std::vector<std::string>& captions, int columns,
                    const Theme& theme, const Workers& workers);

}  // namespace sturnus
