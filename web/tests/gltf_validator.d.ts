declare module 'gltf-validator' {
  interface ValidationReport {
    issues: { numErrors: number; numWarnings: number };
  }
  const validator: { validateBytes(bytes: Uint8Array): Promise<ValidationReport> };
  export default validator;
}
