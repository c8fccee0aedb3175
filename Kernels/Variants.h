// Specialization constants of programs: one text for C++ and GLSL. HostDevice.h includes it.
//
// Sets differ in the arrays that they have and in what their glyphs are. Each difference is a bit, a "variant". A
// program is specialized for those that all of its sets have and those that some have: what none has is not in the
// program, what all have costs no test, and only what sets of one scene differ in is tested in the set's record.

// The arrays of a set, one value a glyph: number, bit, type, the address's name in GlyphSetRecord, where the values
// come from (instances: GlyphInstances; colors: those of Scene::SetColors), and what messages call them. Lengths are
// checked, values sent in the order of the set's tree, and addresses filled in by this table (SceneState.h).
#define RTG_GLYPH_ARRAYS(ARRAY)                                                                                        \
  ARRAY(0, CENTERS, Vec3Array, centers, instances.centers, "centers")                                                  \
  ARRAY(1, CENTERS_LOW, Vec3Array, centersLow, instances.centersLow, "low parts of centers")                           \
  ARRAY(2, SIZE_EACH, FloatArray, sizes1, instances.sizes1, "sizes")                                                   \
  ARRAY(3, SIZES_EACH, Vec3Array, sizes3, instances.sizes3, "sizes along three axes")                                  \
  ARRAY(4, ROTATIONS, Vec4Array, rotations, instances.rotations, "rotations")                                          \
  ARRAY(5, EXPONENTS, Vec3Array, exponents, instances.exponents3, "exponents")                                         \
  ARRAY(6, FORMS, Vec3Array, forms, instances.forms, "quadratic forms")                                                \
  ARRAY(7, VELOCITIES, Vec3Array, velocities, instances.motion.velocities, "velocities")                               \
  ARRAY(8, ACCELERATIONS, Vec3Array, accelerations, instances.motion.accelerations, "accelerations")                   \
  ARRAY(9, ANGULAR_VELOCITIES, Vec3Array, angularVelocities, instances.motion.angularVelocities, "angular velocities") \
  ARRAY(10, OPACITIES, FloatArray, opacities, instances.opacities, "opacities")                                        \
  ARRAY(11, COLORS, UintArray, colors, colors.each, "colors")                                                          \
  ARRAY(12, END_COLORS, Uvec2Array, endColors, colors.ends, "colors of ends")                                          \
  ARRAY(13, BEFORE, Vec4Array, before, instances.before, "ends before pieces of lines")                                \
  ARRAY(14, AFTER, Vec4Array, after, instances.after, "ends after pieces of lines")                                    \
  ARRAY(15, POLYNOMIALS, FloatArray, polynomials, instances.polynomials, "polynomials")

// The numbers of a set: type and name in GlyphSetRecord, and where they come from. Records are filled, and sets sent to
// other processes, by this table.
#define RTG_GLYPH_NUMBERS(NUMBER)                                                                                      \
  NUMBER(uint, shape, instances.shape)                                                                                 \
  NUMBER(float, uniformSize, instances.uniformSize)                                                                    \
  NUMBER(vec3, uniformExponents, instances.uniformExponents)                                                           \
  NUMBER(uint, polynomialDegree, instances.polynomialDegree)                                                           \
  NUMBER(uint, surfaceColors, instances.surfaceColors)                                                                 \
  NUMBER(uint, identifiesTriangles, instances.identifyTriangles)                                                       \
  NUMBER(float, shutterOpen, instances.motion.shutterOpen)                                                             \
  NUMBER(float, shutterClose, instances.motion.shutterClose)                                                           \
  NUMBER(float, shaftRadius, instances.arrow.shaftRadius)                                                              \
  NUMBER(float, tipRadius, instances.arrow.tipRadius)                                                                  \
  NUMBER(float, tipLength, instances.arrow.tipLength)                                                                  \
  NUMBER(float, tipRounding, instances.arrow.tipRounding)                                                              \
  NUMBER(float, unitLength, instances.arrow.unitLength)                                                                \
  NUMBER(uint, fixedHeads, instances.arrow.fixedHeads)

// The members of Material that programs have under the same names.
#define RTG_MATERIAL(MEMBER)                                                                                           \
  MEMBER(vec3, color)                                                                                                  \
  MEMBER(vec3, ambientColor)                                                                                           \
  MEMBER(vec3, specularColor)                                                                                          \
  MEMBER(vec3, positiveColor)                                                                                          \
  MEMBER(vec3, negativeColor)                                                                                          \
  MEMBER(float, ambient)                                                                                               \
  MEMBER(float, diffuse)                                                                                               \
  MEMBER(float, specular)                                                                                              \
  MEMBER(float, specularPower)                                                                                         \
  MEMBER(float, opacity)                                                                                               \
  MEMBER(uint, lighting)                                                                                               \
  MEMBER(float, metallic)                                                                                              \
  MEMBER(float, roughness)                                                                                             \
  MEMBER(float, coatStrength)                                                                                          \
  MEMBER(float, coatRoughness)                                                                                         \
  MEMBER(vec3, coatColor)

#define RTG_BIT(number, BIT, type, name, values, words) const uint BIT = 1u << number;
RTG_GLYPH_ARRAYS(RTG_BIT)
#undef RTG_BIT

// Other features of sets.
const uint FIXED_HEADS = 1u << 16;     // of arrows
const uint ORDER_OF_SLICES = 1u << 17; // slices of time are sorted each for itself
const uint MESH_NORMALS = 1u << 19;
const uint MESH_POSITION_COLORS = 1u << 20;
const uint MESH_TRIANGLE_COLORS = 1u << 21;
const uint MESH_VALUE_COLORS = 1u << 22;
const uint MESH_VELOCITIES = 1u << 23;
const uint MESH_ACCELERATIONS = 1u << 24;
const uint MESH_TREE = 1u << 25;        // the mesh has a tree of our own instead of the driver's
const uint END_VALUES = 1u << 26;       // colors of ends are values with a table of colors (TriangleMesh.h)
const uint SIGN_COLORS = 1u << 27;      // of polynomials
const uint DIRECTION_COLORS = 1u << 28; // of the direction from the center to the surface
const uint SECTION = 1u << 29;          // a cut (Programs/section.glsl)
const uint MOVING_GLYPHS = VELOCITIES | ACCELERATIONS | ANGULAR_VELOCITIES;
const uint MESH_COLORS = MESH_POSITION_COLORS | MESH_TRIANGLE_COLORS | MESH_VALUE_COLORS;
const uint MOVING_MESH = MESH_VELOCITIES | MESH_ACCELERATIONS;
// Features that a new color or time step adds or removes. A program tests every set for these at run time, where a ray
// has hit (in a moving scene at each glyph): lavapipe would compile another program for seconds. Images would take 4 %
// longer if arrays that are read for every candidate were tested, too.
const uint RUN_TIME_FEATURES = COLORS | ORDER_OF_SLICES;

// Every specialization constant of the programs: number, type, name. Each program declares all of them.
#define RTG_CONSTANTS(ENTRY)                                                                                           \
  ENTRY(0, uint, shapes)             /* bit n: some set is of shape n */                                               \
  ENTRY(1, uint, inAllSets)          /* variants of all sets */                                                        \
  ENTRY(2, uint, inSomeSets)         /* variants of some set */                                                        \
  ENTRY(3, bool, independentSamples) /* as TraceSettings has it */                                                     \
  ENTRY(4, bool, alone)              /* the scene has one record, FrameRecord::onlySet */                              \
  ENTRY(5, bool, translucency)       /* some set has opacity below one, and rays pass it at random */                  \
  ENTRY(6, bool, leavesSurface)      /* rays will start from hits */                                                   \
  ENTRY(7, bool, gathersFeatures)    /* normals and so on are summed */                                                \
  ENTRY(8, bool, moves)              /* something in the scene does */                                                 \
  ENTRY(9, bool, environmentImage)   /* the environment light is an image */                                           \
  ENTRY(10, bool, layered)           /* the image is that of translucent sets: opaque ones only hide */                \
  ENTRY(11, bool, manyLights)        /* more than FEW_LIGHTS */                                                        \
  ENTRY(12, uint, degree)            /* the largest of polynomials */                                                  \
  ENTRY(13, bool, rayQueries)        /* rays find candidates in the driver's BVH, not in the plugin's */               \
  ENTRY(14, bool, shadows)           /* as TraceSettings has it */                                                     \
  ENTRY(15, bool, sky)               /* there is environment light */                                                  \
  ENTRY(16, bool, ground)            /* a plane catches shadows */
