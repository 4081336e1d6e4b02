//! The words of WGSL that an author's names must not be.

/// Keywords and reserved words: not allowed anywhere. WGSL specification, keyword summary.
const RESERVED: &str = "
    alias break case const const_assert continue continuing default diagnostic discard else enable false fn
    for if let loop override requires return struct switch true var while NULL Self abstract active alignas
    alignof as asm asm_fragment async attribute auto await become cast catch class co_await co_return co_yield
    coherent column_major common compile compile_fragment concept const_cast consteval constexpr constinit
    crate debugger decltype delete demote demote_to_helper do dynamic_cast enum explicit export extends extern
    external fallthrough filter final finally friend from fxgroup get goto groupshared highp impl implements
    import inline instanceof interface layout lowp macro macro_rules match mediump meta mod module move mut
    mutable namespace new nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null
    nullptr of operator package packoffset partition pass patch pixelfragment precise precision premerge priv
    protected pub public readonly ref regardless register reinterpret_cast require resource restrict self set
    shared sizeof smooth snorm static static_assert static_cast std subroutine super target template this
    thread_local throw trait try type typedef typeid typename typeof union unless unorm unsafe unsized use
    using varying virtual volatile wgsl where with writeonly yield
";

/// Predeclared types, enumerants and functions: allowed as names, but then hidden, and hard on the reader.
const PREDECLARED: &str = "
    bool i32 u32 f32 f16 f64 i64 u64 array atomic vec2 vec3 vec4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4
    mat4x2 mat4x3 mat4x4 ptr sampler sampler_comparison read write read_write function private workgroup
    uniform storage bitcast all any select arrayLength abs acos acosh asin asinh atan atanh atan2 ceil clamp
    cos cosh countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot exp exp2
    extractBits faceForward firstLeadingBit firstTrailingBit floor fma fract frexp insertBits inverseSqrt
    ldexp length log log2 max min mix modf normalize pow quantizeToF16 radians reflect refract reverseBits
    round saturate sign sin sinh smoothstep sqrt step tan tanh transpose trunc dpdx dpdy fwidth
";

/// Whether no identifier may be this word.
pub(super) fn is_reserved(name: &str) -> bool {
    RESERVED.split_whitespace().any(|word| word == name)
}

/// Whether a local name had better not be this word.
pub(super) fn is_word(name: &str) -> bool {
    is_reserved(name) || PREDECLARED.split_whitespace().any(|word| word == name)
}
