// The BRDF of glTF's metallic-roughness materials (glTF 2.0 specification, appendix B): Lambert and GGX.

const float kPi = 3.14159265359;
const float kDielectricF0 = 0.04;     // an index of refraction of 1.5
const float kMinimalRoughness = 0.045;  // the highlight of a point light stays finite in half float (Filament, 4.8.3)

// D: Walter et al. 2007, "Microfacet models for refraction through rough surfaces", equation 33.
float distributionGgx(float nDotH, float alphaSquared) {
    float d = nDotH * nDotH * (alphaSquared - 1.0) + 1.0;
    return alphaSquared / (kPi * d * d);
}

// V = G / (4 nDotL nDotV), height-correlated Smith: Heitz 2014, "Understanding the masking-shadowing function in
// microfacet-based BRDFs", equation 99.
float visibilitySmith(float nDotL, float nDotV, float alphaSquared) {
    float l = nDotV * sqrt(nDotL * nDotL * (1.0 - alphaSquared) + alphaSquared);
    float v = nDotL * sqrt(nDotV * nDotV * (1.0 - alphaSquared) + alphaSquared);
    return 0.5 / max(l + v, 1e-6);
}

// F: Schlick 1994, "An inexpensive BRDF model for physically-based rendering".
vec3 fresnelSchlick(vec3 f0, float vDotH) {
    float x = 1.0 - vDotH;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

// The share of uniform light from everywhere that the highlights reflect: Karis 2014, "Physically based shading on
// mobile", a fit of the split-sum integral.
vec3 mirroredShare(vec3 f0, float roughness, float nDotV) {
    const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022);
    const vec4 c1 = vec4(1.0, 0.0425, 1.04, -0.04);
    vec4 r = roughness * c0 + c1;
    float a = min(r.x * r.x, exp2(-9.28 * nDotV)) * r.x + r.y;
    vec2 scaleBias = vec2(-1.04, 1.04) * a + r.zw;
    return clamp(f0 * scaleBias.x + scaleBias.y, 0.0, 1.0);
}

// What of a surface stays the same for all lights.
struct Reflection {
    vec3 diffuse;   // albedo of the diffuse part: of what the highlights let through
    vec3 mirrored;  // albedo of the highlights, seen from here
    vec3 f0;
    float alphaSquared;
    float nDotV;
};

// Diffuse light is what the highlights leave over (albedo scaling: Kulla and Conty 2017, "Revisiting physically based
// shading at Imageworks"), so that no surface reflects more than it receives, not even at grazing angles.
Reflection reflectionOf(vec3 albedo, float metallic, float roughness, float nDotV) {
    Reflection r;
    r.nDotV = clamp(nDotV, 1e-4, 1.0);
    r.f0 = mix(vec3(kDielectricF0), albedo, metallic);
    r.mirrored = mirroredShare(r.f0, roughness, r.nDotV);
    r.diffuse = (1.0 - r.mirrored) * (1.0 - metallic) * albedo;
    float alpha = max(roughness, kMinimalRoughness);
    alpha *= alpha;
    r.alphaSquared = alpha * alpha;
    return r;
}

// The BRDF times the cosine at the light.
vec3 reflectedShare(Reflection r, vec3 n, vec3 v, vec3 l) {
    float nDotL = dot(n, l);
    if (nDotL <= 0.0) return vec3(0.0);
    vec3 h = normalize(v + l);
    float microfacets = distributionGgx(clamp(dot(n, h), 0.0, 1.0), r.alphaSquared) *
                        visibilitySmith(nDotL, r.nDotV, r.alphaSquared);
    vec3 fresnel = fresnelSchlick(r.f0, clamp(dot(v, h), 0.0, 1.0));
    return (r.diffuse / kPi + fresnel * microfacets) * nDotL;
}
