// What programs are specialised for: one text for C++ and GLSL. HostDevice.h includes it.
//
// Sets differ in the arrays that they have and in what their glyphs are. Each difference is a bit, a "variant". A
// program is told which of them all of its sets have and which some have: what none has is not in the program, what all
// have costs no test, and only what sets of one scene differ in is asked of the set's record.

// An array of the set, or how its values are to be read.
const uint SIZE_EACH = 1u << 0;  // one size a glyph
const uint SIZES_EACH = 1u << 1; // three sizes a glyph
const uint ROTATIONS = 1u << 2;
const uint COLOURS = 1u << 3;     // one colour a glyph
const uint EXPONENTS = 1u << 4;   // three exponents a glyph
const uint CENTRES_LOW = 1u << 5; // low parts of centres
const uint FORMS = 1u << 6;       // colours by the sign of a quadratic form
const uint VELOCITIES = 1u << 7;
const uint ACCELERATIONS = 1u << 8;
const uint ANGULAR_VELOCITIES = 1u << 9;
const uint FIXED_HEADS = 1u << 10;     // of arrows
const uint ORDER_OF_SLICES = 1u << 11; // slices of time are sorted each for itself
const uint DROPS_HIDDEN = 1u << 12;    // most of what a ray might meet lies behind its hit
const uint MESH_NORMALS = 1u << 13;
const uint MESH_POSITION_COLOURS = 1u << 14;
const uint MESH_TRIANGLE_COLOURS = 1u << 15;
const uint MESH_VALUE_COLOURS = 1u << 16;
const uint MESH_VELOCITIES = 1u << 17;
const uint MESH_ACCELERATIONS = 1u << 18;
const uint MESH_TREE = 1u << 19; // the mesh has a tree of our own instead of the driver's
const uint MOVING_GLYPHS = VELOCITIES | ACCELERATIONS | ANGULAR_VELOCITIES;
const uint MESH_COLOURS = MESH_POSITION_COLOURS | MESH_TRIANGLE_COLOURS | MESH_VALUE_COLOURS;
const uint MOVING_MESH = MESH_VELOCITIES | MESH_ACCELERATIONS;

// Every specialisation constant of every program: number, type, name. Each program declares all of them.
#define RTG_CONSTANTS(ENTRY)                                                                                           \
  ENTRY(0, uint, shapes)            /* bit n: some set is of shape n */                                                \
  ENTRY(1, uint, allHave)           /* variants of all sets */                                                         \
  ENTRY(2, uint, someHave)          /* variants of some set */                                                         \
  ENTRY(3, uint, samplerKind)       /* rtg::Sampler */                                                                 \
  ENTRY(4, bool, alone)             /* the scene has one record, FrameRecord::onlySet */                               \
  ENTRY(5, bool, translucency)      /* some set has opacity below one, and rays pass it by chance */                   \
  ENTRY(6, bool, leavesSurface)     /* rays will start from hits */                                                    \
  ENTRY(7, bool, accumulates)       /* samples are added to earlier ones, or will be */                                \
  ENTRY(8, bool, gathersFeatures)   /* normals and so on are summed */                                                 \
  ENTRY(9, bool, develops)          /* colours change on their way to the display */                                   \
  ENTRY(10, bool, moves)            /* something in the scene does */                                                  \
  ENTRY(11, bool, environmentImage) /* light from all around is an image */                                            \
  ENTRY(12, bool, layered)          /* the image is that of translucent sets: opaque ones only hide */
