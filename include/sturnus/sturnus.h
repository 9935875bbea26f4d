// Everything in one header: scenarios, simulations, measures, pictures, shaders, files.
#pragma once

#include <sturnus/files.h>
#include <sturnus/isa.h>
#include <sturnus/measure.h>
#include <sturnus/parameters.h>
#include <sturnus/picture.h>
#include <sturnus/render.h>
#include <sturnus/scenario.h>
#include <sturnus/shaders.h>
#include <sturnus/simulation.h>
#include <sturnus/steering.h>
#include <sturnus/triangles.h>
#include <sturnus/version.h>
#include <sturnus/watch.h>
